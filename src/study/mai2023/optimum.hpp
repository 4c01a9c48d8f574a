// The least fitness that any string of moves over the lattice of the paper has: what ants can reach at best.
#pragma once

#include "alate/core/param_table.hpp"
#include "search/lattice_optimum.hpp"

namespace alate::mai2023 {

/// On the lattice of a planner's parameters over `world`.
std::optional<LatticeOptimum> least_fitness(const World& world, const ParamValues& values);

}  // namespace alate::mai2023
