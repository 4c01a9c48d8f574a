// Any-angle search over a terrain lattice.
#pragma once

#include "search/lattice_astar.hpp"

namespace alate {

/// A cheap route of straight legs between nodes of the lattice, by Lazy Theta* (Nash, Koenig, Tovey 2010): a node is
/// first reached straight from its parent's parent, and whether that leg may be flown is asked only once the node is
/// expanded. Every leg keeps the scenario's limits, exactly, and those of the lattice's rules; a leg may climb less
/// than a level and turn by any angle. Not the best route: each node keeps one parent, so where turns are limited a way
/// may be missed that lattice_astar finds. Costs are the scenario's objective, whatever the lattice scores.
/// Departures: where threats or climbs make a straight leg dearer than the moves it replaces, the moves are kept (there
/// the triangle inequality, which the paper leans on, does not hold).
/// `best->score` is the objective; a route beyond the range is none. Ends where `run` says so.
LatticeWay lattice_theta(const World& world, const TerrainLattice& lattice, RunContext& run);

}  // namespace alate
