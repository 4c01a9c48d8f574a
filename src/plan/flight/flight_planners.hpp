// Planners for flights of Dubins pieces over real ground.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry interval_astar_entry();
/// The same where navigation drifts: from correction point to correction point.
PlannerEntry correction_flight_entry();
PlannerEntry primitive_aco_entry();

}  // namespace alate
