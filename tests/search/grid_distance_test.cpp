#include "search/grid_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/grid_sites.hpp"

namespace alate {
namespace {

using test::corner_space;
using test::grid_of;

TEST(GridDistance, RoundsWallsAndCutsNoCorners) {
  const HeightGrid grid = grid_of({"...", ".#.", "..."});
  const GridSpace space = corner_space(grid, std::numbers::sqrt2);
  EXPECT_EQ(grid_distances(space, space.start())[space.goal()], 4);
}

TEST(GridDistance, IsInfiniteBehindWalls) {
  const HeightGrid grid = grid_of({"..#.", "..#.", "..#.", "..#."});
  const GridSpace space = corner_space(grid, 1.4);
  const std::vector<double> lengths = grid_distances(space, space.start());
  const std::vector<std::uint8_t> reached = space.flood(space.start());
  for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
    EXPECT_EQ(lengths[cell] < kInfinity, reached[cell] != 0) << cell;
}

/// Against sweeps over all moves until nothing changes, and the same from both ends.
TEST(GridDistance, IsTheShortestOnDrawnMaps) {
  for (const double diagonal : {1.4, std::numbers::sqrt2}) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const HeightGrid grid = test::drawn_grid(17, seed, 0.3);
      const GridSpace space = corner_space(grid, diagonal);
      const double there = grid_distances(space, space.start())[space.goal()];
      const double back = grid_distances(space, space.goal())[space.start()];
      if (std::isinf(there)) {
        EXPECT_TRUE(std::isinf(back) && std::isinf(test::shortest_length(space))) << seed;
        continue;
      }
      EXPECT_NEAR(there, test::shortest_length(space), 1e-12 * there) << seed;
      EXPECT_NEAR(back, there, 1e-12 * there) << seed;
    }
  }
}

}  // namespace
}  // namespace alate
