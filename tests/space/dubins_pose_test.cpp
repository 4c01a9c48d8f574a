#include "space/dubins/planar_pose.hpp"

#include <gtest/gtest.h>

#include "space/dubins/arctangent.hpp"
#include "space/dubins_poses.hpp"

namespace alate {
namespace {

using namespace dubins_test;

TEST(Arctangent, IsThatOfTheLibraryToRounding) {
  Random random;
  for (int i = 0; i < 200000; ++i) {
    const double x = random.between(-1, 1) * std::exp2(random.between(-40, 1));
    const double y = random.between(-1, 1) * std::exp2(random.between(-40, 1));
    ASSERT_NEAR(arctangent(y, x), std::atan2(y, x), 5e-16);
    if (std::abs(y) < x) {
      ASSERT_NEAR(arctangent(y, x), std::atan2(y, x), 4e-16 * std::abs(y / x));
    }
  }
  EXPECT_EQ(arctangent(0, 0), 0);
  EXPECT_EQ(arctangent(0, -1), kPi);
  EXPECT_EQ(arctangent(-1, 0), -kPi / 2);
}

TEST(PlanarMotion, ManyTurnsAddUp) {
  PlanarPose pose = planar_pose(5, -3, 1);
  const PlanarMotion turn = planar_motion(Steering::left, 2 * kPi * kRadius / 16, kRadius);
  for (int i = 0; i < 1600; ++i) pose = moved(pose, turn);
  EXPECT_LE(gap(pose, planar_pose(5, -3, 1)), 1e-9);
  EXPECT_LE(gap(moved(pose, planar_motion(Steering::right, 3.5 * kPi * kRadius, kRadius)),
                moved(pose, planar_motion(Steering::right, 1.5 * kPi * kRadius, kRadius))),
            1e-9);
}

}  // namespace
}  // namespace alate
