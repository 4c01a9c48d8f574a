// What all planners on the attitude lattice share: guidance, lower bound and the way from actions to a Plan.
#pragma once

#include <functional>
#include <string>

#include "alate/core/param_table.hpp"
#include "alate/plan/planner.hpp"
#include "search/search_result.hpp"
#include "space/attitude.hpp"

namespace alate {

/// Why the lattice cannot serve this problem, naming the missing keys; empty if it can.
std::string attitude_refusal(const Problem& problem);

/// `step_limit`, which all of them have.
Parameter step_limit_parameter();

/// Builds the space (guided round terrain and threats), runs `search` on it and wraps up what it found. Without a route
/// `why` says what stands in the way.
Plan plan_on_attitudes(const Problem& problem, RunContext& run, const AttitudeOptions& options,
                       const std::function<SearchResult(const AttitudeSpace&)>& search);

}  // namespace alate
