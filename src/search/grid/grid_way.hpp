// What exact searches on grids are asked and answer.
#pragma once

#include <vector>

#include "search/grid/bit_grid.hpp"
#include "search/grid/octile.hpp"

namespace alate {

/// A way from start to goal, or none.
struct GridWay {
  bool found = false;
  bool proven = false;             ///< No way is shorter, or there is none at all. False after a stop.
  std::vector<GridPlace> corners;  ///< Start, the cells where the direction changes, goal.
  OctileLength length;
  std::uint64_t expansions = 0;
};

/// Adds the end of a straight run of cells to a way; runs in one direction are joined.
void add_corner(GridWay& way, GridPlace place);

/// Expansions between two looks at the clock.
inline constexpr std::uint64_t kPollEvery = 1024;

}  // namespace alate
