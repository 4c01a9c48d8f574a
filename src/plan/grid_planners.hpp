// The planners on height grids, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry grid_aco_entry();

}  // namespace alate
