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

/// Wider than words of bits, and few walls: scans, and cones over many cells.
TEST_F(AnyaTest, IsAsShortOnWideMaps) {
  std::mt19937_64 random(12);
  int turned = 0;
  for (int map = 0; map < 60; ++map) {
    const bool tall = map % 2 == 0;
    HeightGrid grid = random_grid(tall ? 5 : 150, tall ? 150 : 5, 1 + random() % 8, random);
    const CellPlace start = free_cell(grid, random);
    const CellPlace goal = free_cell(grid, random);
    const BitGrid cells(grid);
    Anya search(cells);
    const AnyAngleWay way = find(search, start, goal);
    const double least = test::shortest_any_angle(grid, start, goal);
    ASSERT_EQ(way.found, std::isfinite(least)) << map;
    if (!way.found) continue;
    EXPECT_NEAR(way.length, least, 1e-9) << map;
    turned += way.points.size() > 2 ? 1 : 0;
  }
  EXPECT_GT(turned, 20);
}

TEST_F(AnyaTest, SmallMaps) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  EXPECT_EQ(length({"."}, {0, 0}, {0, 0}), 0);
  EXPECT_EQ(length({".."}, {0, 0}, {1, 0}), 1);
  EXPECT_EQ(length({"....."}, {4, 0}, {0, 0}), 4);
  EXPECT_EQ(length({".", ".", "."}, {0, 2}, {0, 0}), 2);
  EXPECT_EQ(length({"..#.."}, {0, 0}, {4, 0}), kNone);
  EXPECT_EQ(length({".", "#", "."}, {0, 0}, {0, 2}), kNone);
  EXPECT_DOUBLE_EQ(length({"...", "...", "..."}, {0, 2}, {2, 0}), std::sqrt(8));
  EXPECT_EQ(length({".#", "#."}, {0, 0}, {1, 1}), kNone) << "slips between two blocked cells";
}

/// Past one, round two, and round the end of a wall that touches the border.
TEST_F(AnyaTest, TurnsAtCorners) {
  EXPECT_DOUBLE_EQ(length({"..", ".#"}, {0, 1}, {1, 0}), std::sqrt(2)) << "straight past a corner";
  EXPECT_DOUBLE_EQ(length({"...", ".#.", "..."}, {0, 1}, {2, 1}), 1 + 2 * std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(length({"...#", ".#..", ".#..", ".#.."}, {0, 3}, {3, 3}),
                   std::hypot(0.5, 2.5) + 1 + std::hypot(1.5, 2.5));
}

TEST_F(AnyaTest, AStoppedSearchProvesNothing) {
  const HeightGrid grid = test::grid_of({"....", ".##.", "...."});
  const BitGrid cells(grid);
  Anya search(cells);
  std::stop_source source;
  source.request_stop();
  RunContext run(executor, {.stop = source.get_token()});
  const AnyAngleWay way = search.find(BitGrid::place(0, 1), BitGrid::place(3, 1), run);
  EXPECT_FALSE(way.found);
  EXPECT_FALSE(way.finished);
}

/// Every row of the small maps, every tenth of the large ones: there and back.
TEST_F(AnyaTest, BenchmarkMapsThereAndBack) {
  ALATE_NEEDS_SHARED_DATA("movingai/2d");
  std::size_t rows = 0;
  for (const std::string name :
       {"arena", "den312d", "lak303d", "Boston_0_256", "brc202d", "Berlin_1_512", "Paris_1_1024"}) {
    std::vector<Fault> faults;
    const auto scen = read_scen_file(test::shared_data("movingai/2d/" + name + ".map.scen").string(), faults);
    ASSERT_TRUE(scen.has_value()) << to_string(faults.front());
    const BitGrid cells(scen->grid);
    Anya search(cells);
    const std::size_t every = scen->rows.size() > 500 ? 10 : 1;
    for (std::size_t i = 0; i < scen->rows.size(); i += every) {
      const ScenRow& row = scen->rows[i];
      const CellPlace start{row.start_column, row.start_row};
      const CellPlace goal{row.goal_column, row.goal_row};
      const AnyAngleWay way = find(search, start, goal);
      ASSERT_TRUE(way.found && way.finished) << name << " row " << i;
      EXPECT_LE(way.length, row.optimum + scen_tolerance(row.optimum)) << name << " row " << i;
      EXPECT_GE(way.length, std::hypot(start[0] - goal[0], start[1] - goal[1]) - 1e-9) << name << " row " << i;
      EXPECT_NEAR(walked(scen->grid, way.points).value_or(-1), way.length, 1e-9) << name << " row " << i;
      const auto& [there, back] = std::pair(goal, start);
      EXPECT_NEAR(find(search, there, back).length, way.length, 1e-9) << name << " row " << i;
      ++rows;
    }
  }
  EXPECT_GT(rows, 1000U);
}

}  // namespace
}  // namespace alate
