// Exact searches on grids against Dijkstra's algorithm and against published lengths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "data/scen_file.hpp"
#include "search/grid/astar.hpp"
#include "search/grid/directions.hpp"
#include "search/grid/jps.hpp"
#include "support/grid_sites.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

template <class Search>
struct GridSearch : testing::Test {
  GridWay find(Search& search, GridPlace start, GridPlace goal) {
    RunContext run(executor, {});
    return search.find(start, goal, run);
  }
  Executor executor{1};
};
using Searches = testing::Types<GridAStar, JumpPointSearch>;
TYPED_TEST_SUITE(GridSearch, Searches);

/// Follows the way cell by cell; its length, or nothing if a move is not free.
std::optional<OctileLength> walked(const BitGrid& grid, const std::vector<GridPlace>& corners) {
  OctileLength length;
  GridPlace at = corners.front();
  for (const GridPlace corner : corners) {
    while (at != corner) {
      const auto sign = [](int from, int to) { return (to > from ? 1 : 0) - (to < from ? 1 : 0); };
      const std::array shift{sign(at.column, corner.column), sign(at.row, corner.row)};
      const auto d = static_cast<unsigned>(std::ranges::find(kGridShifts, shift) - kGridShifts.begin());
      if (((grid.moves(grid.cell(at)) >> d) & 1U) == 0) return std::nullopt;
      at = moved(at, d);
      ++(d % 2 == 0 ? length.straights : length.diagonals);
    }
  }
  return length;
}

HeightGrid random_grid(int columns, int rows, std::mt19937_64& random) {
  HeightGrid grid{.columns = columns, .rows = rows, .blocked = {}, .height_m = {}};
  const std::uint64_t share = random() % 60;
  for (int i = 0; i < columns * rows; ++i) grid.blocked.push_back(random() % 100 < share ? 1 : 0);
  return grid;
}

std::array<int, 2> free_cell(HeightGrid& grid, std::mt19937_64& random) {
  const auto column = static_cast<int>(random() % static_cast<unsigned>(grid.columns));
  const auto row = static_cast<int>(random() % static_cast<unsigned>(grid.rows));
  grid.blocked[grid.index(column, row)] = 0;
  return {column, row};
}

/// Maps of all shapes and densities, some with lanes longer than two words; several queries each, so that what one
/// query leaves behind would show in the next.
TYPED_TEST(GridSearch, IsAsShortAsDijkstras) {
  std::mt19937_64 random(7);
  int without = 0;
  for (int map = 0; map < 400; ++map) {
    const int columns = 1 + static_cast<int>(random() % (map % 4 == 0 ? 150 : 24));
    const int rows = 1 + static_cast<int>(random() % (map % 5 == 0 ? 150 : 24));
    HeightGrid grid = random_grid(columns, rows, random);
    std::array<std::array<int, 2>, 8> ends{};
    for (auto& end : ends) end = free_cell(grid, random);
    const BitGrid cells(grid);
    TypeParam search(cells);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const auto [a, b] = ends[i];
      const auto [c, d] = ends[i + 1];
      const double least = test::shortest_length(GridSpace(grid, {a, b, c, d}, std::numbers::sqrt2, {}));
      const GridWay way = this->find(search, BitGrid::place(a, b), BitGrid::place(c, d));
      ASSERT_TRUE(way.finished);
      ASSERT_EQ(way.found, std::isfinite(least)) << map;
      without += way.found ? 0 : 1;
      if (!way.found) continue;
      ASSERT_NEAR(way.length.value(), least, 1e-9) << map;
      EXPECT_EQ(way.corners.front(), BitGrid::place(a, b));
      EXPECT_EQ(way.corners.back(), BitGrid::place(c, d));
      const auto length = walked(cells, way.corners);
      ASSERT_TRUE(length.has_value()) << map;
      EXPECT_EQ(*length, way.length);
    }
  }
  EXPECT_GT(without, 50);
}

TYPED_TEST(GridSearch, CornersAreWhereTheDirectionChanges) {
  const HeightGrid grid = test::grid_of({"......", ".####.", "......"});
  const BitGrid cells(grid);
  TypeParam search(cells);
  const GridWay way = this->find(search, BitGrid::place(0, 2), BitGrid::place(5, 0));
  EXPECT_EQ(way.length, (OctileLength{.straights = 7, .diagonals = 0}));
  EXPECT_EQ(way.corners.size(), 3U);
}

/// The number of a query begins anew after so many.
TYPED_TEST(GridSearch, ForgetsWithoutClearing) {
  const HeightGrid grid = test::grid_of({"....", ".##.", "...."});
  const BitGrid cells(grid);
  TypeParam search(cells);
  for (int i = 0; i < 40'000; ++i) {
    const bool there = i % 2 == 0;
    const GridWay way = this->find(search, BitGrid::place(there ? 0 : 3, 0), BitGrid::place(there ? 3 : 0, 2));
    ASSERT_EQ(way.length, (OctileLength{.straights = 5, .diagonals = 0})) << i;
  }
}

TYPED_TEST(GridSearch, AStoppedSearchProvesNothing) {
  const HeightGrid grid = test::grid_of({"....", ".##.", "...."});
  const BitGrid cells(grid);
  TypeParam search(cells);
  std::stop_source source;
  source.request_stop();
  RunContext run(this->executor, {.stop = source.get_token()});
  const GridWay way = search.find(BitGrid::place(0, 0), BitGrid::place(3, 2), run);
  EXPECT_FALSE(way.found);
  EXPECT_FALSE(way.finished);
}

/// Every row of seven maps for jump point search; every tenth for A*, which takes longer.
TYPED_TEST(GridSearch, ReachesThePublishedOptima) {
  ALATE_NEEDS_SHARED_DATA("movingai/2d");
  constexpr std::size_t kEvery = std::is_same_v<TypeParam, JumpPointSearch> ? 1 : 10;
  std::size_t rows = 0;
  for (const std::string name :
       {"arena", "den312d", "lak303d", "Boston_0_256", "brc202d", "Berlin_1_512", "Paris_1_1024"}) {
    std::vector<Fault> faults;
    const auto scen = read_scen_file(test::shared_data("movingai/2d/" + name + ".map.scen").string(), faults);
    ASSERT_TRUE(scen.has_value()) << to_string(faults.front());
    const BitGrid cells(scen->grid);
    TypeParam search(cells);
    for (std::size_t i = 0; i < scen->rows.size(); i += kEvery) {
      const ScenRow& row = scen->rows[i];
      const GridWay way = this->find(search, BitGrid::place(row.start_column, row.start_row),
                                     BitGrid::place(row.goal_column, row.goal_row));
      EXPECT_NEAR(way.length.value(), row.optimum, scen_tolerance(row.optimum)) << name << " row " << i;
      ++rows;
    }
  }
  EXPECT_EQ(rows, kEvery == 1 ? 10'719U : 1'072U);
}

TEST(Octile, OrdersLengthsAsTheyAre) {
  EXPECT_LT(7 * kStraight, 5 * kDiagonal);
  EXPECT_LT(kDiagonal * 15'994'428, kStraight * 22'619'537);  // the next convergents, on both sides of sqrt(2)
  EXPECT_GT(kDiagonal * 6'625'109, kStraight * 9'369'319);
  for (std::int64_t straights = 0; straights < 300; ++straights) {
    const auto whole = static_cast<std::int64_t>(static_cast<double>(straights) / std::numbers::sqrt2);
    EXPECT_LE(static_cast<OctileCost>(whole) * kDiagonal, static_cast<OctileCost>(straights) * kStraight);
    EXPECT_GT(static_cast<OctileCost>(whole + 1) * kDiagonal, static_cast<OctileCost>(straights) * kStraight);
  }
}

}  // namespace
}  // namespace alate
