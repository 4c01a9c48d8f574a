// The least fitness that any string of moves over the lattice of the paper has: what ants can reach at best.
#pragma once

#include <optional>
#include <vector>

#include "alate/core/param_table.hpp"
#include "space/terrain_lattice.hpp"

namespace alate::mai2023 {

/// Lattice, rules and score of a planner's parameters, for constraints that filter.
LatticeOptions lattice_options(const ParamValues& values);

struct Optimum {
  double fitness = 0;
  std::vector<Vec3> places;
};

/// Exact, by dynamic programming from plane to plane over nodes and last moves, since turns count and are limited.
/// O(nodes x moves^2). Limits of the whole route are not seen to. Nothing where no route is.
std::optional<Optimum> least_fitness(const TerrainLattice& lattice);

/// On the lattice of `values` over `world`.
std::optional<Optimum> least_fitness(const World& world, const ParamValues& values);

}  // namespace alate::mai2023
