// How much nearer to the goal each move of a terrain lattice leads, for tables.
#pragma once

#include "space/terrain_lattice.hpp"

namespace alate {

/// eta = 1 / d, d the distance from the end of the move to the goal, no less than half a step: the textbook's
/// visibility, as (eta / best of the node)^beta, in case the baseline of Mai et al. 2023 used that instead of S M D.
AlignedFloats lattice_distance_table(const TerrainLattice& lattice, int beta);

/// exp(-detour / temperature), where the detour of a move is how much dearer it and the straight rest are than the best
/// move of its node; as in heuristic/goal_directed.hpp. The temperature is in steps of the main direction. Source:
/// alate.
AlignedFloats lattice_directed_table(const TerrainLattice& lattice, double temperature);

}  // namespace alate
