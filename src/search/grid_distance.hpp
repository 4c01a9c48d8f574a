// Exact lengths of shortest ways on a grid.
#pragma once

#include <vector>

#include "space/height_grid.hpp"

namespace alate {

/// Length of the shortest way from `from` to every cell, in cell sides, by the step costs of the space; infinite where
/// no moves lead. Moves lead back as they lead there, so this is the length to `from` as well.
///
/// Uniform-cost search (Dijkstra 1959) with a binary heap: O(n log n) for n cells. Sums of steps are of doubles, so
/// lengths are exact to rounding.
std::vector<double> grid_distances(const GridSpace& space, GridSpace::Cell from);

}  // namespace alate
