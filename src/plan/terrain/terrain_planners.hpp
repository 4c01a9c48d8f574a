// The planners on terrain lattices, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry terrain_aco_entry();
PlannerEntry terrain_astar_entry();
PlannerEntry terrain_theta_star_entry();

/// Ground to fly over, and not cells to step on.
bool is_over_terrain(const Site& site);

}  // namespace alate
