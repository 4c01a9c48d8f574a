// A way that touches corners, moved off them by a hair.
#pragma once

#include <vector>

#include "search/grid/bit_grid.hpp"
#include "search/grid/cone.hpp"

namespace alate {

/// Between middles of free cells, along legs that touch blocked cells but do not cut them. Wherever a leg touches a
/// corner of a blocked cell, or passes one within a few hairs, the way gets a point `hair` (cell sides) off it across
/// and along, so that it passes through the free cell beside the corner. Points between two others on one wall are left
/// out. What is added to the length is at most 3 hairs a corner.
std::vector<GridPoint> kept_clear(const BitGrid& grid, const std::vector<GridPoint>& points, double hair);

}  // namespace alate
