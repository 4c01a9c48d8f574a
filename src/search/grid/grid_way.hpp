// What exact searches on grids are asked and answer.
#pragma once

#include <vector>

#include "search/grid/bit_grid.hpp"
#include "search/grid/octile.hpp"

namespace alate {

/// A way from start to goal, or none.
struct GridWay {
  bool found = false;
  bool finished = false;  ///< False after a stop: then it is not proven that there is no way, or no shorter one.
  std::vector<GridPlace> corners;  ///< Start, the cells where the direction changes, goal.
  OctileLength length;             ///< Of ways from cell to cell.
  std::uint64_t expansions = 0;
};

/// Adds the end of a straight run of cells to a way; runs in one direction are joined.
void add_corner(GridWay& way, GridPlace place);

/// By how much the priority of an open cell can exceed that of the one expanded, after runs of any length.
inline OctileCost widest_spread(const BitGrid& grid) {
  return 2 * kDiagonal * (static_cast<OctileCost>(grid.columns()) + static_cast<OctileCost>(grid.rows()));
}

/// Expansions between two looks at the clock.
inline constexpr std::uint64_t kPollEvery = 1024;

}  // namespace alate
