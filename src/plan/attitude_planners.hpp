// The planners on the attitude lattice, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry greedy_entry();
PlannerEntry beam_entry();

}  // namespace alate
