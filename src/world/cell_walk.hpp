// The cells that a straight leg crosses, in order (Amanatides and Woo 1987), with jumps over whole blocks.
#pragma once

#include <algorithm>
#include <limits>

#include "alate/core/geometry.hpp"

namespace alate {

/// A leg straight in post coordinates, with its height along the way.
struct PostLeg {
  Vec2 from;
  Vec2 to;
  double z = 0;
  double dz = 0;
};

/// Position (column, row) and parameter t in [0, 1] of a walk. The parameter at which a grid line is crossed is
/// always computed from the line alone, so a jump arrives in the same cell, with the same bits, as single steps.
struct CellWalk {
  double x, y, dx, dy, z, dz;
  double per_dx, per_dy;
  int side_x, side_y;  ///< Of a cell, the side through which it is left: 0 low, 1 high; 2 if never.
  int step_x, step_y;
  int cell_columns, cell_rows;
  int column, row;
  double t = 0;

  /// Where a block is left: through a column line or a row line, or not at all (t = 1).
  struct Exit {
    double t = 1;
    bool through_column = false;
  };

  /// Both ends lie within the posts.
  CellWalk(const PostLeg& leg, int columns, int rows)
      : x(leg.from.x()),
        y(leg.from.y()),
        dx(leg.to.x() - x),
        dy(leg.to.y() - y),
        z(leg.z),
        dz(leg.dz),
        per_dx(1 / dx),
        per_dy(1 / dy),
        side_x(side(dx)),
        side_y(side(dy)),
        step_x(2 * int{dx > 0} - 1),
        step_y(2 * int{dy > 0} - 1),
        cell_columns(columns),
        cell_rows(rows),
        column(std::min(static_cast<int>(x), columns - 1)),
        row(std::min(static_cast<int>(y), rows - 1)) {
    // A line two cells away in a direction without motion is reached at +infinity.
    if (dx == 0) per_dx = std::numeric_limits<double>::infinity();
    if (dy == 0) per_dy = std::numeric_limits<double>::infinity();
  }

  double height(double at) const { return z + dz * at; }

  /// Exit of the block of 2^shift x 2^shift cells that holds the current cell.
  Exit exit(int shift) const {
    const int line_x = ((column >> shift) + side_x) << shift;
    const int line_y = ((row >> shift) + side_y) << shift;
    const double t_x = (line_x - x) * per_dx;
    const double t_y = (line_y - y) * per_dy;
    // Where a column line and a row line are crossed at once, the column line comes first.
    const bool through_column = t_x <= t_y;
    return {std::min(through_column ? t_x : t_y, 1.0), through_column};
  }

  /// From the current cell to the next; false at the end of the leg. Without branches, since no processor could
  /// guess which way a leg turns.
  bool step(const Exit& exit) {
    column += exit.through_column ? step_x : 0;
    row += exit.through_column ? 0 : step_y;
    t = exit.t;
    return t < 1 && inside();
  }

  /// From the current cell to the first one behind a block's exit; false at the end of the leg.
  bool leave(const Exit& exit, int shift) {
    if (exit.t >= 1) return false;
    if (exit.through_column) {
      near(row, y + dy * exit.t, step_y);
      while ((row + side_y - y) * per_dy < exit.t) row += step_y;
      column = behind(column, shift, side_x);
    } else {
      near(column, x + dx * exit.t, step_x);
      while ((column + side_x - x) * per_dx <= exit.t) column += step_x;
      row = behind(row, shift, side_y);
    }
    t = exit.t;
    return inside();
  }

 private:
  /// Rounding may cross the last line a hair before the end.
  bool inside() const { return column >= 0 && row >= 0 && column < cell_columns && row < cell_rows; }
  static int behind(int cell, int shift, int side) {
    const int line = ((cell >> shift) + side) << shift;
    return side == 1 ? line : line - 1;
  }
  /// Moves `cell` to one before `position` if it is far behind; rounding is far less than a cell.
  static void near(int& cell, double position, int step) {
    const int before = static_cast<int>(position) - step;
    if ((before - cell) * step > 0) cell = before;
  }
  static int side(double d) { return int{d > 0} + 2 * int{d == 0}; }
};

}  // namespace alate
