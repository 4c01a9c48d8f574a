// The heuristic of Mai et al. 2023: eta = S M D.
//
// Source: eqs. (11)-(13), verbatim except for the numerators P and K, which cancel in every choice and are 1 here. S
// is 1 for open moves (space/lattice_moves.hpp). Open in the paper, and options here: the unit of heights and distances
// beside the "1 +", and whether the 1 under the first root is a unit step or a literal.
#pragma once

#include "space/terrain_lattice.hpp"

namespace alate {

struct TerrainFactorRule {
  enum class Unit { km, cells };

  int beta = 2;
  Unit unit = Unit::km;
  bool literal_one = true;  ///< The 1 under the first root as printed; else the step in the main direction.
};

/// (eta / best of the node)^beta for tables: the same chances.
AlignedFloats terrain_factor_table(const TerrainLattice& lattice, const TerrainFactorRule& rule);

/// M D of one leg, lengths in the unit: `step` and `rest` along main direction, side and height; `height` above the
/// sea.
double terrain_factors(const Vec3& step, const Vec3& rest, double height, bool literal_one);

}  // namespace alate
