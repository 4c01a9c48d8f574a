// The shortest way at any angle, from a visibility graph: an oracle that shares nothing with the searches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "alate/data/height_grid.hpp"

namespace alate::test {

/// In half cells, columns and rows from the upper left corner: corners of cells are even, middles odd.
using HalfPoint = std::array<std::int64_t, 2>;

inline bool wall_at(const HeightGrid& grid, std::int64_t column, std::int64_t row) {
  const auto c = static_cast<int>(column);
  const auto r = static_cast<int>(row);
  return !grid.contains(c, r) || grid.blocked_at(c, r);
}

/// Does the open line between two points meet the inside of a cell? By separating axes, in whole numbers.
inline bool cuts(HalfPoint a, HalfPoint b, std::int64_t column, std::int64_t row) {
  const HalfPoint low{2 * column, 2 * row};
  for (std::size_t i = 0; i < 2; ++i)
    if (std::max(a.at(i), b.at(i)) <= low.at(i) || std::min(a.at(i), b.at(i)) >= low.at(i) + 2) return false;
  bool before = false;
  bool after = false;
  for (const HalfPoint corner : {low, {low[0] + 2, low[1]}, {low[0], low[1] + 2}, {low[0] + 2, low[1] + 2}}) {
    const std::int64_t side = (b[0] - a[0]) * (corner[1] - a[1]) - (b[1] - a[1]) * (corner[0] - a[0]);
    before = before || side < 0;
    after = after || side > 0;
  }
  return before && after;
}

/// Two blocked cells that share a corner, with nothing but the corner between them.
inline bool is_pinched(const HeightGrid& grid, std::int64_t column, std::int64_t row) {
  const auto wall = [&](std::int64_t c, std::int64_t r) { return wall_at(grid, column + c, row + r); };
  return (wall(-1, -1) && wall(0, 0)) || (wall(0, -1) && wall(-1, 0));
}

/// May a straight line lead from one point to another, along sides and past corners too?
inline bool is_legal(const HeightGrid& grid, HalfPoint a, HalfPoint b) {
  const auto [left, right] = std::minmax(a[0], b[0]);
  const auto [top, bottom] = std::minmax(a[1], b[1]);
  for (std::int64_t row = top / 2 - 1; row <= bottom / 2; ++row)
    for (std::int64_t column = left / 2 - 1; column <= right / 2; ++column)
      if (wall_at(grid, column, row) && cuts(a, b, column, row)) return false;
  const std::int64_t pieces = std::gcd(b[0] - a[0], b[1] - a[1]);
  if (pieces == 0) return true;
  const HalfPoint step{(b[0] - a[0]) / pieces, (b[1] - a[1]) / pieces};
  for (std::int64_t i = 1; i < pieces; ++i) {
    const HalfPoint at{a[0] + i * step[0], a[1] + i * step[1]};
    const bool corner = at[0] % 2 == 0 && at[1] % 2 == 0;
    if (corner && is_pinched(grid, at[0] / 2, at[1] / 2)) return false;
    if (step[1] == 0 && at[1] % 2 == 0 && at[0] % 2 != 0 && wall_at(grid, (at[0] - 1) / 2, at[1] / 2) &&
        wall_at(grid, (at[0] - 1) / 2, at[1] / 2 - 1))
      return false;
    if (step[0] == 0 && at[0] % 2 == 0 && at[1] % 2 != 0 && wall_at(grid, at[0] / 2, (at[1] - 1) / 2) &&
        wall_at(grid, at[0] / 2 - 1, (at[1] - 1) / 2))
      return false;
  }
  return true;
}

/// Corners of exactly one blocked cell: a shortest way turns nowhere else.
inline std::vector<HalfPoint> turning_points(const HeightGrid& grid) {
  std::vector<HalfPoint> points;
  for (std::int64_t row = 0; row <= grid.rows; ++row) {
    for (std::int64_t column = 0; column <= grid.columns; ++column) {
      int walls = 0;
      for (const auto& [c, r] : {std::array{-1, -1}, std::array{0, -1}, std::array{-1, 0}, std::array{0, 0}})
        walls += wall_at(grid, column + c, row + r) ? 1 : 0;
      if (walls == 1) points.push_back({2 * column, 2 * row});
    }
  }
  return points;
}

/// Lengths in cell sides from the first of some points to all of them, infinite where there is no way.
inline std::vector<double> shortest_lengths(const HeightGrid& grid, const std::vector<HalfPoint>& points) {
  std::vector<double> lengths(points.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> closed(points.size());
  lengths.front() = 0;
  for (std::size_t round = 0; round < points.size(); ++round) {
    std::size_t at = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!closed[i] && (at == points.size() || lengths[i] < lengths[at])) at = i;
    if (!std::isfinite(lengths[at])) break;
    closed[at] = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double apart = std::hypot(points[i][0] - points[at][0], points[i][1] - points[at][1]) / 2;
      if (!closed[i] && lengths[at] + apart < lengths[i] && is_legal(grid, points[at], points[i]))
        lengths[i] = lengths[at] + apart;
    }
  }
  return lengths;
}

/// Between the middles of two cells.
inline double shortest_any_angle(const HeightGrid& grid, std::array<int, 2> start, std::array<int, 2> goal) {
  std::vector<HalfPoint> points = turning_points(grid);
  points.insert(points.begin(), {2 * start[0] + 1, 2 * start[1] + 1});
  points.push_back({2 * goal[0] + 1, 2 * goal[1] + 1});
  return shortest_lengths(grid, points).back();
}

}  // namespace alate::test
