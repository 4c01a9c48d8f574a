#include "data/grid_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace alate {
namespace {

HeightGrid peaks_grid(int side) {
  return {.columns = side, .rows = side, .blocked = {}, .height_m = peak_heights(side, side)};
}

/// 100 times the standard deviation (n - 1) of the heights of `cells`.
double deviation(const HeightGrid& grid, const std::vector<std::array<int, 2>>& cells) {
  std::vector<double> heights;
  for (const auto& [column, row] : cells) heights.push_back(grid.height_at(column, row));
  const auto count = static_cast<double>(heights.size());
  const double mean = std::accumulate(heights.begin(), heights.end(), 0.0) / count;
  double squares = 0;
  for (const double height : heights) squares += (height - mean) * (height - mean);
  return 100 * std::sqrt(squares / (count - 1));
}

/// The first `count` cells in the order of columns.
std::vector<std::array<int, 2>> first_cells(int side, int count) {
  std::vector<std::array<int, 2>> cells;
  for (int i = 0; i < count; ++i) cells.push_back({i / side, i % side});
  return cells;
}

TEST(PeakHeights, LargestAreThoseOfTheReference) {
  for (const auto& [side, largest] : {std::pair{10, 7.1622}, {20, 7.5561}, {30, 8.0208}})
    EXPECT_NEAR(std::ranges::max(peak_heights(side, side)), largest, 5e-5) << side;
}

TEST(PeakHeights, FirstColumnsDeviateAsInTheReference) {
  const HeightGrid large = peaks_grid(30);
  for (const auto& [count, expected] :
       {std::pair{30, 8.79}, {36, 8.32}, {39, 8.05}, {42, 10.26}, {45, 15.86}, {48, 17.51}, {60, 16.28}})
    EXPECT_NEAR(deviation(large, first_cells(30, count)), expected, 0.005) << count;
  const HeightGrid small = peaks_grid(10);
  for (const auto& [count, expected] :
       {std::pair{10, 8.93}, {12, 8.37}, {13, 8.58}, {14, 28.69}, {15, 66.49}, {16, 75.39}})
    EXPECT_NEAR(deviation(small, first_cells(10, count)), expected, 0.005) << count;
}

TEST(PeakHeights, DiagonalAndBordersDeviateAsInTheReference) {
  const HeightGrid grid = peaks_grid(30);
  std::vector<std::array<int, 2>> diagonal;
  std::vector<std::array<int, 2>> lower_right;
  std::vector<std::array<int, 2>> upper_left;
  for (int i = 0; i < 30; ++i) {
    diagonal.push_back({i, 29 - i});
    lower_right.push_back({i, 29});
    upper_left.push_back({0, 29 - i});
  }
  for (int i = 1; i < 30; ++i) {
    lower_right.push_back({29, 29 - i});
    upper_left.push_back({i, 0});
  }
  EXPECT_NEAR(deviation(grid, diagonal), 111.3, 0.05);
  EXPECT_NEAR(deviation(grid, lower_right), 8.45, 0.005);
  EXPECT_NEAR(deviation(grid, upper_left), 6.82, 0.005);
}

TEST(PeakHeights, OtherShapes) {
  EXPECT_EQ(peak_heights(1, 1).size(), 1U);
  const auto wide = peak_heights(40, 3);
  EXPECT_EQ(wide.size(), 120U);
  for (const float height : wide) EXPECT_TRUE(std::isfinite(height) && height >= 0);
}

TEST(DrawGrid, BlocksTheShareAskedForAndKeepsTheEndsFree) {
  const RandomGridSpec spec{.size = {200, 100}, .obstacles = 0.2, .seed = 7};
  const HeightGrid grid = draw_grid(spec, {{0, 99}}, {{199, 0}});
  EXPECT_EQ(grid.blocked.size(), 20'000U);
  // Four standard deviations of 20 000 draws.
  EXPECT_NEAR(std::accumulate(grid.blocked.begin(), grid.blocked.end(), 0.0) / 20'000, 0.2, 0.0113);
  for (int seed = 0; seed < 50; ++seed) {
    const HeightGrid full = draw_grid({.size = {3, 3}, .obstacles = 1, .seed = seed}, {{0, 2}}, {{2, 0}});
    EXPECT_EQ(full.blocked, (std::vector<std::uint8_t>{1, 1, 0, 1, 1, 1, 0, 1, 1}));
  }
}

TEST(DrawGrid, IsAFunctionOfItsSeed) {
  const RandomGridSpec spec{.size = {30, 30}, .obstacles = 0.2, .seed = 1};
  EXPECT_EQ(draw_grid(spec, {}, {}).blocked, draw_grid(spec, {}, {}).blocked);
  RandomGridSpec other = spec;
  other.seed = 2;
  EXPECT_NE(draw_grid(spec, {}, {}).blocked, draw_grid(other, {}, {}).blocked);
  EXPECT_EQ(draw_grid(spec, {{50, 0}}, {{-1, 2}}).blocked, draw_grid(spec, {}, {}).blocked);
}

}  // namespace
}  // namespace alate
