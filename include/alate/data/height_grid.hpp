// A grid of square cells, free or blocked, each with a height: the ground of planners that step from cell to cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

/// Row 0 is the top (north), column 0 the left (west). Routes lie in one plane: lengths are planar, and the height is
/// an attribute of a cell, as in Yin et al. 2021.
struct HeightGrid {
  int columns = 0;
  int rows = 0;
  double cell_m = 1;
  Vec2 origin = Vec2::Zero();         ///< Lower left corner in the frame.
  double level_m = 0;                 ///< z of every route.
  std::vector<std::uint8_t> blocked;  ///< Row-major, columns * rows; 1 is blocked.
  std::vector<float> height_m;        ///< Row-major; empty: flat. NaN where ground is unknown, in blocked cells only.

  bool contains(int column, int row) const { return column >= 0 && column < columns && row >= 0 && row < rows; }
  /// Index of a cell that the grid contains.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  bool blocked_at(int column, int row) const { return blocked[index(column, row)] != 0; }
  double height_at(int column, int row) const { return height_m.empty() ? 0 : double{height_m[index(column, row)]}; }
  /// origin + ((column + 0.5) cell, (rows - 1 - row + 0.5) cell): y points north, so row 0 has the largest y.
  Vec3 center(int column, int row) const {
    return {origin.x() + (column + 0.5) * cell_m, origin.y() + (rows - 1 - row + 0.5) * cell_m, level_m};
  }
  /// Column and row of the cell around `xy`; nothing outside the grid.
  std::optional<std::array<int, 2>> cell_at(const Vec2& xy) const {
    const Vec2 at = (xy - origin) / cell_m;
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns && at.y() < rows)) return std::nullopt;
    return {{static_cast<int>(at.x()), rows - 1 - static_cast<int>(at.y())}};
  }
  Box2 area() const { return {origin, origin + Vec2(columns * cell_m, rows * cell_m)}; }
};

/// What Yin et al. 2021 judge a route over a grid by.
struct GridMeasures {
  double length_cells = 0;        ///< L, in cell sides.
  double height_deviation_m = 0;  ///< F, standard deviation (n - 1) of the heights of the cells passed, as meant.
  std::size_t turns = 0;          ///< T, changes of direction.
};

/// S = 1 L + 100 F + 1 T, lower is better. The weights are those of the public program of Li et al. 2019; the paper
/// shows none.
constexpr double composite_index(const GridMeasures& measures) {
  constexpr double kLengthWeight = 1;
  constexpr double kDeviationWeight = 100;
  constexpr double kTurnWeight = 1;
  return kLengthWeight * measures.length_cells + kDeviationWeight * measures.height_deviation_m +
         kTurnWeight * static_cast<double>(measures.turns);
}

}  // namespace alate
