// What all planners on terrain lattices share: when they refuse, why there is no route, and the way from a string of
// moves to a Plan.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "aco/walk/lattice_walk.hpp"
#include "alate/plan/planner.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

/// Why a lattice over terrain cannot serve this problem; empty if it can.
std::string terrain_refusal(const Problem& problem);

/// What a search on a lattice found.
struct LatticeFound {
  std::vector<Vec3> places;  ///< From start to goal; empty: no route.
  std::uint64_t moves = 0;   ///< That were tried.
  LatticeTally tally;
  std::vector<IterationStats> history;
  bool is_exhausted = false;  ///< No string of moves is a route.
};

using TerrainSearch = std::function<LatticeFound(const TerrainLattice&)>;

/// Builds the space, searches and wraps up; again with a side_share of 1 where a smaller one leads nowhere. That no
/// string of moves leads to the goal proves nothing beyond the lattice: none_found, with the plane that moves from the
/// start reach at most, or word that turns or length forbid what moves allow. The history tells what the colony ranks
/// by; the plan's cost is that of the scenario's objective. The lower bound is that of the continuous problem.
/// Counters: dead_ends; last_change, the last iteration that changed the best so far; broken_*: how often each
/// constraint was broken by ants that arrived, barred_*: how many candidates it took away.
Plan plan_over_terrain(const Problem& problem, RunContext& run, const LatticeOptions& options,
                       const TerrainSearch& search);

}  // namespace alate
