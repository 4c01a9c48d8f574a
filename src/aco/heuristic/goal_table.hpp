// How good each move of a grid looks, for tables: eta^beta in rows of eight by cell, 0 where a move is not free.
#pragma once

#include "space/height_grid.hpp"

namespace alate {

/// eta = 1 / d_jE: the nearer the goal, the better (the visibility of Dorigo, Maniezzo, Colorni 1996 as it is commonly
/// put on grids). A cell has side 1; the goal itself counts as half a cell away.
AlignedFloats goal_distance_table(const GridSpace& space, int beta);

/// exp(-detour / temperature), where the detour of a move is its cost and how much nearer it leads, were all cells
/// free, as in heuristic/goal_directed.hpp. Source: alate.
AlignedFloats goal_directed_table(const GridSpace& space, double temperature);

}  // namespace alate
