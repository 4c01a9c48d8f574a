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

}  // namespace alate
