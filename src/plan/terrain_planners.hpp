// The planners on terrain lattices, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry terrain_aco_entry();

}  // namespace alate
