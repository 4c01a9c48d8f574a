// The planners on correction points, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry label_setting_entry();
PlannerEntry correction_ga_entry();
PlannerEntry sparse_astar_entry();
PlannerEntry correction_aco_entry();

}  // namespace alate
