// The best string of moves over a terrain lattice, exactly.
#pragma once

#include <optional>
#include <vector>

#include "space/terrain_lattice.hpp"

namespace alate {

struct LatticeOptimum {
  double score = 0;  ///< As the lattice scores.
  std::vector<Vec3> places;
};

/// Exact, by dynamic programming from plane to plane over nodes and last moves, since turns count and are limited.
/// O(nodes x moves^2). Limits of the whole route are not seen to; constraints must filter. Nothing where no route is.
std::optional<LatticeOptimum> lattice_optimum(const TerrainLattice& lattice);

}  // namespace alate
