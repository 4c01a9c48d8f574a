// A* over a terrain lattice.
#pragma once

#include <optional>
#include <vector>

#include "search/lattice_optimum.hpp"

namespace alate {

struct LatticeWay {
  std::optional<LatticeOptimum> best;
  std::uint64_t expansions = 0;
  bool finished = true;  ///< Not stopped: without a best there is no string of moves to the goal.
};

/// The best string of moves, exactly: A* (Hart, Nilsson, Raphael 1968) over nodes, and over last moves where turns
/// count. Unlike lattice_optimum it keeps limits of the whole route: where the cheapest string is too long, it
/// searches again, and of the labels of a state, expanded by rising score, keeps those that are shorter than all before
/// them (bi-objective A*: Hernandez Ulloa et al. 2020). The heuristic is the straight way to the goal. Constraints must
/// filter. Ends where `run` says so, or with 16 million labels; without a limit dynamic programming then takes over.
LatticeWay lattice_astar(const TerrainLattice& lattice, RunContext& run);

}  // namespace alate
