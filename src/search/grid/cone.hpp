// What one point sees of a row of cells: the intervals of Anya.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace alate {

/// A place on the map in cell sides, x to the right, y down, counted with the rim: cell c spans [c, c + 1], so corners
/// are whole numbers and middles of cells end in 1/2.
struct GridPoint {
  double x = 0;
  double y = 0;

  bool operator==(const GridPoint&) const = default;
};

inline double distance(const GridPoint& a, const GridPoint& b) {
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

/// A point where a shortest way turned at last, or the start.
struct Root {
  GridPoint at;
  double length = 0;         ///< Of the way from the start.
  std::uint32_t corner = 0;  ///< Its number.
};

/// The two outer rays of a cone, in columns per row.
struct Rays {
  static constexpr double kWide = std::numeric_limits<double>::infinity();

  double left = -kWide;
  double right = kWide;
};

/// The rays from a root that enter a row of cells side by side, all free up to there (Harabor et al. 2016: an interval,
/// here as the two rays through its ends). A ray is kept as columns per row, always the quotient of two small whole
/// numbers of half cells and so the same double wherever it comes from: projections do not add up errors.
struct Cone {
  Root root;
  Rays rays;
  int row = 0;   ///< That it enters.
  int down = 1;  ///< 1 if rows go down, -1 if they go up.

  /// The line it enters its row by.
  double line() const { return down > 0 ? row : row + 1; }
  /// Rows from the root to that line.
  double depth() const { return down > 0 ? row - root.at.y : root.at.y - (row + 1); }
  /// Where a ray meets a line at a depth. On a corner if it lies within rounding of one: rays through corners meet
  /// lines at multiples of 1 / (4 rows), and maps have less than 65,536 rows.
  double meets(double ray, double at_depth) const {
    constexpr double kRounding = 1e-6;
    const double x = root.at.x + ray * at_depth;
    // Never below 0, and quicker than lround.
    const auto corner = static_cast<double>(static_cast<int>(x + 0.5));  // NOLINT(bugprone-incorrect-roundings)
    return std::abs(x - corner) < kRounding ? corner : x;
  }
  /// No way through the cone is shorter: straight to the goal, or past the ray next to it. A goal on the root's side of
  /// the line is as far as its mirror image.
  double least_length(const GridPoint& goal) const {
    const double rows = depth();
    const double beyond = std::abs(goal.y - line());
    const double across = goal.x - root.at.x;
    const double straight = rows + beyond;
    if (across < rays.left * straight) return past(rays.left * rows, across, rows, beyond);
    if (across > rays.right * straight) return past(rays.right * rows, across, rows, beyond);
    return root.length + std::sqrt(across * across + straight * straight);
  }

 private:
  double past(double x, double across, double rows, double beyond) const {
    return root.length + std::sqrt(x * x + rows * rows) + std::sqrt((across - x) * (across - x) + beyond * beyond);
  }
};

}  // namespace alate
