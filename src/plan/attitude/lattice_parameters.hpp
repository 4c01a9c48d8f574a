// Parameters of terrain lattices: what every planner on them needs, beside what it does there.
#pragma once

#include "alate/plan/registry.hpp"
#include "space/terrain_lattice.hpp"

namespace alate {

/// Steps and window, which legs are moves, constraints (1) to (5) of Mai et al. 2023, and how routes are scored.
std::vector<Parameter> lattice_parameters();

/// What these parameters say. A planner may leave out safety, dead_ends and constraints with its penalty, and the
/// fitness with its weights: they are then as by default.
LatticeOptions lattice_options(const ParamValues& values);

}  // namespace alate
