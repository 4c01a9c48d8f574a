// What planners of flights over real ground do before and after their own work.
#pragma once

#include <functional>
#include <string_view>

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"

namespace alate {

/// Nothing found yet, but the bound of the straight line; with the start as its route where that lies within the goal's
/// tolerance.
Plan begin_flight(const Site& site, const RunContext& run);

/// Takes a route that costs less than what is there; not one beyond `vehicle.range_m`, which the plan says if it has no
/// other.
void keep_if_better(const Site& site, Route route, double cost, Plan& plan);

/// Counters, the way it stopped, and why there is no route if there is none: `nothing`, unless it was stopped or is
/// told already.
void conclude_flight(Plan& plan, const RunContext& run, std::string_view nothing);

/// All of a flight but `fly`, which is called where neither the start lies at the goal nor a barrier is proven.
Plan plan_flight(const Problem& problem, RunContext& run, std::string_view nothing,
                 const std::function<void(Plan&)>& fly);

}  // namespace alate
