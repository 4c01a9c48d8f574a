// Parameters of terrain lattices: what every planner on them needs, beside what it does there.
#pragma once

#include "alate/plan/registry.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

/// Steps and window, which legs are moves, constraints (1) to (5) of Mai et al. 2023, and how routes are scored.
std::vector<Parameter> lattice_parameters();

/// What these parameters say.
LatticeOptions lattice_options(const ParamValues& values);

}  // namespace alate
