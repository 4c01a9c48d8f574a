// Shortest ways at any angle against a visibility graph and on the benchmark maps.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "data/scen_file.hpp"
#include "search/grid/anya.hpp"
#include "search/visibility_graph.hpp"
#include "support/grid_sites.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

using CellPlace = std::array<int, 2>;

struct AnyaTest : testing::Test {
  AnyAngleWay find(Anya& search, CellPlace start, CellPlace goal) {
    RunContext run(executor, {});
    return search.find(BitGrid::place(start[0], start[1]), BitGrid::place(goal[0], goal[1]), run);
  }
  double length(const std::vector<std::string>& lines, CellPlace start, CellPlace goal) {
    const HeightGrid grid = test::grid_of(lines);
    const BitGrid cells(grid);
    Anya search(cells);
    const AnyAngleWay way = find(search, start, goal);
    EXPECT_TRUE(way.finished);
    return way.found ? way.length : std::numeric_limits<double>::infinity();
  }
  Executor executor{1};
};

/// Without the rim.
test::HalfPoint half_point(const GridPoint& point) {
  return {std::lround(2 * point.x) - 2, std::lround(2 * point.y) - 2};
}

/// Of legs that are legal, one by one.
std::optional<double> walked(const HeightGrid& grid, const std::vector<GridPoint>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!test::is_legal(grid, half_point(points[i - 1]), half_point(points[i]))) return std::nullopt;
    length += distance(points[i - 1], points[i]);
  }
  return length;
}

HeightGrid random_grid(int columns, int rows, std::uint64_t percent, std::mt19937_64& random) {
  HeightGrid grid{.columns = columns, .rows = rows, .blocked = {}, .height_m = {}};
  for (int i = 0; i < columns * rows; ++i) grid.blocked.push_back(random() % 100 < percent ? 1 : 0);
  return grid;
}

CellPlace free_cell(HeightGrid& grid, std::mt19937_64& random) {
  const auto column = static_cast<int>(random() % static_cast<unsigned>(grid.columns));
  const auto row = static_cast<int>(random() % static_cast<unsigned>(grid.rows));
  grid.blocked[grid.index(column, row)] = 0;
  return {column, row};
}

TEST_F(AnyaTest, IsAsShortAsTheVisibilityGraph) {
  std::mt19937_64 random(11);
  int without = 0;
  int turned = 0;
  for (int map = 0; map < 600; ++map) {
    const int columns = 1 + static_cast<int>(random() % 16);
    const int rows = 1 + static_cast<int>(random() % 16);
    HeightGrid grid = random_grid(columns, rows, random() % 50, random);
    std::array<CellPlace, 4> ends{};
    for (CellPlace& end : ends) end = free_cell(grid, random);
    const BitGrid cells(grid);
    Anya search(cells);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double least = test::shortest_any_angle(grid, ends[i], ends[i + 1]);
      const AnyAngleWay way = find(search, ends[i], ends[i + 1]);
      ASSERT_TRUE(way.finished);
      ASSERT_EQ(way.found, std::isfinite(least)) << map;
      without += way.found ? 0 : 1;
      if (!way.found) continue;
      turned += way.points.size() > 2 ? 1 : 0;
      ASSERT_NEAR(way.length, least, 1e-9) << map;
      const auto length = walked(grid, way.points);
      ASSERT_TRUE(length.has_value()) << map;
      EXPECT_NEAR(*length, way.length, 1e-9);
    }
  }
  EXPECT_GT(without, 100);
  EXPECT_GT(turned, 500);
}

}  // namespace
}  // namespace alate
