// Straight runs of cells, a word of bits at a time.
#pragma once

#include <bit>

#include "search/grid/bit_grid.hpp"

namespace alate {

/// From a free cell along its lane to the first cell at which a shortest way may have to turn: the cell beside it is
/// free and the one before that is blocked. Or up to a wall.
struct StraightRun {
  unsigned steps = 0;  ///< To the cell to turn at, or to the blocked one.
  bool turns = false;
};

/// Towards larger numbers. Stops are blocked cells and those at whose side a wall ends (Harabor and Grastien 2014).
inline StraightRun run_ahead(const BitLanes& lanes, BitLanes::Cell cell) {
  constexpr std::uint64_t kBits = (std::uint64_t{1} << BitLanes::kShown) - 2;  // all that are shown but `cell`
  for (unsigned steps = 0;; steps += BitLanes::kShown - 1, cell += BitLanes::kShown - 1) {
    const std::uint64_t here = lanes.from(cell);
    const std::uint64_t left = lanes.from(cell - lanes.stride());
    const std::uint64_t right = lanes.from(cell + lanes.stride());
    const std::uint64_t stops = (here | ((left << 1U) & ~left) | ((right << 1U) & ~right)) & kBits;
    if (stops == 0) continue;
    const auto first = static_cast<unsigned>(std::countr_zero(stops));
    return {steps + first, ((here >> first) & 1U) == 0};
  }
}

/// Towards smaller numbers.
inline StraightRun run_back(const BitLanes& lanes, BitLanes::Cell cell) {
  constexpr std::uint64_t kBits = (~std::uint64_t{0} << (64 - BitLanes::kShown)) & (~std::uint64_t{0} >> 1U);
  for (unsigned steps = 0;; steps += BitLanes::kShown - 1, cell -= BitLanes::kShown - 1) {
    const std::uint64_t here = lanes.until(cell);
    const std::uint64_t left = lanes.until(cell - lanes.stride());
    const std::uint64_t right = lanes.until(cell + lanes.stride());
    const std::uint64_t stops = (here | ((left >> 1U) & ~left) | ((right >> 1U) & ~right)) & kBits;
    if (stops == 0) continue;
    const auto first = static_cast<unsigned>(std::countl_zero(stops));
    return {steps + first, ((here << first) >> 63U) == 0};
  }
}

/// From `place` in a straight direction.
inline StraightRun run_in(const BitGrid& grid, GridPlace place, unsigned direction) {
  switch (direction) {
    case 0:
      return run_ahead(grid.by_row(), grid.by_row().cell(place.column, place.row));
    case 2:
      return run_back(grid.by_column(), grid.by_column().cell(place.row, place.column));
    case 4:
      return run_back(grid.by_row(), grid.by_row().cell(place.column, place.row));
    default:
      return run_ahead(grid.by_column(), grid.by_column().cell(place.row, place.column));
  }
}

}  // namespace alate
