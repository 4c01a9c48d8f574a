// The planners on height grids, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry jps_entry();
PlannerEntry astar_entry();
PlannerEntry theta_star_entry();
PlannerEntry grid_aco_entry();

}  // namespace alate
