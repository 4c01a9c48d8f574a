// Lines of sight among voxels, and the ways that follow them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "alate/check/check.hpp"
#include "search/voxel/line_of_sight.hpp"
#include "search/voxel/voxel_theta.hpp"
#include "support/voxel_sites.hpp"

namespace alate {
namespace {

Route straight(const VoxelGrid& voxels, const VoxelCell& a, const VoxelCell& b) {
  Route route;
  route.states = {{.position = voxels.center(a), .leg = LegKind::start}, {.position = voxels.center(b)}};
  return route;
}

bool sees(const VoxelGrid& voxels, const VoxelCell& a, const VoxelCell& b) {
  const VoxelBits bits(voxels);
  return is_in_sight(bits, VoxelBits::place(a), VoxelBits::place(b));
}

/// The witness computes in metres with slack, the search in whole numbers.
TEST(LineOfSight, IsWhatTheCheckLetsPass) {
  std::mt19937_64 random(3);
  int seen = 0;
  for (int map = 0; map < 3000; ++map) {
    Site site = test::voxel_site(test::drawn_voxels({7, 6, 5}, static_cast<unsigned>(random() % 25), random));
    const auto cell = [&] {
      VoxelCell at{static_cast<int>(random() % 7), static_cast<int>(random() % 6), static_cast<int>(random() % 5)};
      site.voxels->free(at);
      return at;
    };
    const VoxelCell a = cell();
    const VoxelCell b = cell();
    site.mission.start = site.voxels->center(a);
    site.mission.goal = site.voxels->center(b);
    const bool free = check(site, straight(*site.voxels, a, b)).ok();
    EXPECT_EQ(sees(*site.voxels, a, b), free) << map;
    EXPECT_EQ(sees(*site.voxels, b, a), free) << map;
    seen += free ? 1 : 0;
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(seen, 2800);
}

TEST(LineOfSight, PassesEdgesAndCornersOnlyInTheOpen) {
  VoxelGrid voxels({9, 9, 9});
  EXPECT_TRUE(sees(voxels, {0, 0, 0}, {8, 8, 8}));
  voxels.block({4, 4, 5});
  EXPECT_FALSE(sees(voxels, {0, 0, 0}, {8, 8, 8}));
  EXPECT_TRUE(sees(voxels, {0, 0, 0}, {8, 8, 4}));
  EXPECT_TRUE(sees(voxels, {4, 4, 4}, {4, 4, 4}));
}

TEST(VoxelTheta, TurnsRoundACornerInTwoLegs) {
  VoxelGrid voxels({11, 11, 3});
  for (int y = 0; y < 9; ++y)
    for (int z = 0; z < 3; ++z) voxels.block({5, y, z});
  const VoxelBits bits(voxels);
  VoxelTheta theta(bits);
  Executor executor(1);
  RunContext run(executor, {});
  const VoxelWay way = theta.find(VoxelBits::place({0, 0, 0}), VoxelBits::place({10, 0, 0}), run);
  ASSERT_TRUE(way.found);
  double length = 0;
  for (std::size_t i = 1; i < way.corners.size(); ++i)
    length += line_length(way.corners[i - 1], way.corners[i]) / static_cast<double>(kVoxelStraight);
  // Up to beside the wall's end, along it for two cells, and back.
  EXPECT_NEAR(length, 2 * std::hypot(4, 9) + 2, 1e-9);
  EXPECT_EQ(way.corners.size(), 4U);
}

}  // namespace
}  // namespace alate
