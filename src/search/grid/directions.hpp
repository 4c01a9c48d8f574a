// The eight directions on a grid, counter-clockwise from east; odd ones are diagonal.
#pragma once

#include <array>

#include "search/grid/bit_grid.hpp"

namespace alate {

inline constexpr std::array<std::array<int, 2>, BitGrid::kDirections> kGridShifts{
    {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

constexpr GridPlace moved(GridPlace place, unsigned direction, int steps = 1) {
  return {static_cast<std::uint16_t>(place.column + kGridShifts[direction][0] * steps),
          static_cast<std::uint16_t>(place.row + kGridShifts[direction][1] * steps)};
}

constexpr unsigned turned(unsigned direction, unsigned eighths) { return (direction + eighths) % BitGrid::kDirections; }

/// Steps in a straight direction from one place to another; 0 if it does not lie there.
constexpr int steps_to(GridPlace from, GridPlace to, unsigned direction) {
  const auto [across, along] = kGridShifts[direction];
  if (across == 0) return from.column == to.column ? (to.row - from.row) * along : 0;
  return from.row == to.row ? (to.column - from.column) * across : 0;
}

}  // namespace alate
