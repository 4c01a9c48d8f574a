// What must hold of Dubins' distance whatever the way it is computed.
#include <gtest/gtest.h>

#include <vector>

#include "space/dubins_poses.hpp"
#include "space/dubins_reference.hpp"

namespace alate {
namespace {

using namespace dubins_test;

TEST(Dubins, NearlyStraightLegsHaveNoFullTurn) {
  for (const double ahead : {1e-12, 1e-6, 1e-3, 0.5, 1.0, 3.0, 1e3, 1e6}) {
    for (const double error : {0.0, 1e-16, -1e-16, 1e-12, -1e-12, 2 * kPi, -2 * kPi, 200 * kPi}) {
      for (const double heading : {0.0, 1.0, kPi, -kPi, -3 * kPi / 4}) {
        const PlanarPose from = planar_pose(1234.5, -321.25, heading);
        const PlanarPose there = moved(from, planar_motion(Steering::straight, ahead * kRadius, kRadius));
        const PlanarPose to = planar_pose(there.x, there.y, heading + error);
        EXPECT_NEAR(dubins_length(from, to, kRadius), ahead * kRadius, tolerance(from, to)) << text(from) << text(to);
      }
    }
  }
}

TEST(Dubins, ASingleArcIsFoundAgain) {
  for (const double angle : {1e-12, 1e-6, 0.1, kPi / 2, kPi, 3.0, 4.0, 2 * kPi - 1e-6}) {
    for (const Steering side : {Steering::left, Steering::right}) {
      const PlanarPose from = planar_pose(-4.5e5, 5.1e6, 2.5);
      const PlanarPose to = moved(from, planar_motion(side, angle * kRadius, kRadius));
      EXPECT_LE(dubins_length(from, to, kRadius), angle * kRadius + tolerance(from, to)) << angle;
    }
  }
}

TEST(Dubins, ChainsOfPiecesAreNeverLonger) {
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const PlanarPose from = random.pose(1e5);
    PlanarPose to = from;
    double flown = 0;
    for (int piece = 0; piece < 3; ++piece) {
      // Whole multiples bring words together.
      const double length = kRadius * kPi / 8 * std::floor(random.between(0, 5));
      const auto steering = static_cast<Steering>(std::floor(random.between(-1, 2)));
      to = moved(to, planar_motion(steering, length, kRadius));
      flown += length;
    }
    ASSERT_LE(dubins_length(from, to, kRadius), flown + tolerance(from, to)) << text(from) << " to " << text(to);
  }
}

TEST(Dubins, EqualPosesAreNoDistanceApart) {
  for (const double heading : {0.0, 1.0, kPi, -kPi, 7.0}) {
    const PlanarPose pose = planar_pose(3e5, -7e6, heading);
    EXPECT_EQ(dubins_length(pose, pose, kRadius), 0);
    EXPECT_LE(dubins_length(pose, planar_pose(pose.x, pose.y, heading + 2 * kPi), kRadius), 1e-12 * kRadius);
  }
}

TEST(Dubins, KeepsTheTriangleInequality) {
  // Corners at which many words tie. They are kept away from the slack: three goals, each within it, add up.
  const std::vector<double> places{0, kRadius, -2 * kRadius, 4 * kRadius, 4 * kRadius + 1e-6};
  const std::vector<double> headings{0, kPi / 2, kPi, -kPi / 2, 1e-6};
  std::vector<PlanarPose> poses;
  for (const double x : places) {
    for (const double y : places) {
      for (const double heading : headings) poses.push_back(planar_pose(x, y, heading));
    }
  }
  Random random;
  for (int i = 0; i < 60; ++i) poses.push_back(random.pose(i < 30 ? 2 : 10));
  std::vector<std::vector<double>> lengths;
  for (const PlanarPose& a : poses) {
    lengths.emplace_back();
    for (const PlanarPose& b : poses) lengths.back().push_back(dubins_length(a, b, kRadius));
  }
  for (std::size_t a = 0; a < poses.size(); ++a) {
    for (std::size_t b = 0; b < poses.size(); ++b) {
      for (std::size_t c = 0; c < poses.size(); ++c)
        ASSERT_LE(lengths[a][c], lengths[a][b] + lengths[b][c] + 1e-6)
            << text(poses[a]) << text(poses[b]) << text(poses[c]);
    }
  }
}

TEST(Dubins, IsContinuousFarApart) {
  // Beyond four radii the distance has no jumps: a goal moved by d and turned by a costs at most a detour around it.
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const PlanarPose from = random.pose(50);
    const PlanarPose to = random.pose(50);
    if (std::hypot(to.x - from.x, to.y - from.y) < 4.5 * kRadius) continue;
    constexpr double kMoved = 1e-7;
    const PlanarPose near = planar_pose(to.x + random.between(-kMoved, kMoved), to.y + random.between(-kMoved, kMoved),
                                        to.heading + random.between(-kMoved, kMoved));
    ASSERT_NEAR(dubins_length(from, near, kRadius), dubins_length(from, to, kRadius), 20 * kMoved * kRadius)
        << text(from) << " to " << text(to);
  }
}

TEST(Dubins, ScalesWithTheRadius) {
  const PlanarPose from = planar_pose(1, 2, 0.5);
  const PlanarPose to = planar_pose(-3, 1, -2);
  EXPECT_NEAR(dubins_length(from, to, 1), reference::shortest(from, to, 1), 1e-12);
  EXPECT_NEAR(dubins_length(from, to, 1e-6), std::hypot(4, 1), 1e-4);
  const double one = dubins_length(from, to, 1);
  const PlanarPose far_from = planar_pose(1e6, 2e6, 0.5);
  const PlanarPose far_to = planar_pose(-3e6, 1e6, -2);
  EXPECT_NEAR(dubins_length(far_from, far_to, 1e6), 1e6 * one, 1e-6);
}

}  // namespace
}  // namespace alate
