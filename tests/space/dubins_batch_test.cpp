#include "space/dubins/dubins_batch.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "space/dubins/dubins_path.hpp"
#include "space/dubins_poses.hpp"

namespace alate {
namespace {

using namespace dubins_test;

TEST(DubinsBatch, IsTheSameBitsAsSingly) {
  Random random;
  PoseColumns from;
  PoseColumns to;
  std::vector<PlanarPose> from_poses;
  std::vector<PlanarPose> to_poses;
  for (int i = 0; i < 1003; ++i) {
    from_poses.push_back(random.pose(i % 2 == 0 ? 3 : 100));
    to_poses.push_back(i % 7 == 0 ? from_poses.back() : random.pose(3));
    from.push_back(from_poses.back());
    to.push_back(to_poses.back());
  }
  AlignedDoubles pairs;
  AlignedDoubles to_one;
  AlignedDoubles from_one;
  dubins_lengths(from, to, kRadius, pairs);
  dubins_lengths(from, to_poses[5], kRadius, to_one);
  dubins_lengths(from_poses[5], to, kRadius, from_one);
  for (std::size_t i = 0; i < from.size(); ++i) {
    ASSERT_EQ(pairs[i], dubins_length(from_poses[i], to_poses[i], kRadius));
    ASSERT_EQ(to_one[i], dubins_length(from_poses[i], to_poses[5], kRadius));
    ASSERT_EQ(from_one[i], dubins_length(from_poses[5], to_poses[i], kRadius));
  }
}

}  // namespace
}  // namespace alate
