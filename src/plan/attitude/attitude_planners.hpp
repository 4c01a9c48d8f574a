// The planners on the attitude lattice, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry greedy_entry();
PlannerEntry beam_entry();
PlannerEntry attitude_aco_entry();

}  // namespace alate
