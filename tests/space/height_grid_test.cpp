#include "space/height_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/grid_sites.hpp"

namespace alate {
namespace {

using test::corner_space;
using test::grid_of;

constexpr std::uint32_t kEast = 0, kNorthEast = 1, kNorth = 2;

unsigned open_at(const GridSpace& space, int column, int row) {
  for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
    if (space.column(cell) == column && space.row(cell) == row) return space.open(cell);
  return 0;
}

TEST(GridSpace, DiagonalsNeedBothCellsBeside) {
  const HeightGrid grid = grid_of({"...", "...", "..."});
  const GridSpace open = corner_space(grid, 1.4);
  EXPECT_EQ(open_at(open, 1, 1), 0xFFU);
  EXPECT_EQ(open_at(open, 0, 2), (1U << kEast) | (1U << kNorthEast) | (1U << kNorth));
  const HeightGrid blocked = grid_of({".#.", "...", "..."});  // north of the middle
  EXPECT_EQ(open_at(corner_space(blocked, 1.4), 1, 1), 0xFFU & ~0b1110U);
  const HeightGrid corner = grid_of({"#..", "...", "..."});  // north-west of the middle
  EXPECT_EQ(open_at(corner_space(corner, 1.4), 1, 1), 0xFFU & ~0b1000U);
}

TEST(GridSpace, EveryMoveCanBeTakenBack) {
  const HeightGrid grid = test::drawn_grid(25, 4);
  const GridSpace space = corner_space(grid, 1.4);
  for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
    for (unsigned d = 0; d < GridSpace::kDirections; ++d)
      if (((space.open(cell) >> d) & 1U) != 0) {
        EXPECT_TRUE(((space.open(space.neighbour(cell, d)) >> ((d + 4) % 8)) & 1U) != 0);
      }
}

TEST(GridSpace, MeasuresByHand) {
  HeightGrid grid = grid_of({"...", "...", "..."});
  grid.height_m = {0, 0, 6, 0, 4, 0, 2, 0, 0};
  const GridScore score{.height_dev = 100, .turns = 1};
  const GridSpace space = corner_space(grid, 1.4, score);
  const std::vector<std::uint32_t> straight{kNorthEast, kNorthEast};  // heights 2, 4, 6
  EXPECT_DOUBLE_EQ(space.measure(straight).length_cells, 2.8);
  EXPECT_DOUBLE_EQ(space.measure(straight).height_deviation_m, 2);
  EXPECT_EQ(space.measure(straight).turns, 0U);
  EXPECT_DOUBLE_EQ(space.fly(straight)->cost, 2.8 + 200);
  const std::vector<std::uint32_t> bent{kEast, kNorthEast, kNorth};  // heights 2, 0, 0, 6
  EXPECT_DOUBLE_EQ(space.measure(bent).length_cells, 3.4);
  EXPECT_DOUBLE_EQ(space.measure(bent).height_deviation_m, std::sqrt(24.0 / 3));
  EXPECT_EQ(space.measure(bent).turns, 2U);
  EXPECT_FALSE(space.fly(std::vector<std::uint32_t>{kEast}));
  EXPECT_FALSE(space.fly(std::vector<std::uint32_t>{4, kEast}));
}

/// F as coded is a function of the number of cells; values worked out from the program's formula.
TEST(GridSpace, HeightsOfTheMatrixAreThoseOfThePublicProgram) {
  HeightGrid grid = test::drawn_grid(30, 1, 0);
  const GridSpace space = corner_space(grid, 1.4, {.heights_of = GridScore::HeightsOf::matrix});
  for (const auto& [cells, published] : {std::pair{30, 8.79}, {36, 8.32}, {39, 8.05}, {42, 10.26}, {48, 17.51}})
    EXPECT_NEAR(100 * space.measure(std::vector<std::uint32_t>(static_cast<std::size_t>(cells) - 1)).height_deviation_m,
                published, 0.005)
        << cells;
}

TEST(GridSpace, TrueHeightsOfTheDiagonalAreThoseOfTheReference) {
  HeightGrid grid = test::drawn_grid(30, 1, 0);
  const GridSpace space = corner_space(grid, 1.4);
  const double deviation = space.measure(std::vector<std::uint32_t>(29, kNorthEast)).height_deviation_m;
  EXPECT_NEAR(100 * deviation, 111.3, 0.05);
}

TEST(GridSpace, OctileIsTheLengthWithoutObstacles) {
  const HeightGrid grid = test::drawn_grid(12, 1, 0);
  const GridSpace space = corner_space(grid, std::numbers::sqrt2);
  EXPECT_NEAR(test::shortest_length(space), space.octile(space.start(), space.goal()), 1e-12);
  EXPECT_DOUBLE_EQ(space.octile(space.start(), space.start() + 5), 5);
}

TEST(GridSpace, FloodStopsAtWalls) {
  const HeightGrid grid = grid_of({"..#.", "..#.", "..#.", "..#."});
  const GridSpace space = corner_space(grid, 1.4);
  const std::vector<std::uint8_t> reached = space.flood(space.start());
  EXPECT_EQ(std::count(reached.begin(), reached.end(), 1), 8);
  EXPECT_EQ(reached[space.goal()], 0);
}

}  // namespace
}  // namespace alate
