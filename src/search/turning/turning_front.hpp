// Routes with turns: the shortest, or the whole front of length and number of corrections.
#pragma once

#include "alate/core/run_context.hpp"
#include "search/label_setting/front.hpp"
#include "space/turning_flight.hpp"

namespace alate {

/// With arc and tangent exact: without a stop the routes are the Pareto front, or with `shortest_alone` the shortest
/// route, and bound_m is its length. Headings at the points that are free are found by local optimization on every
/// sequence of points whose straight legs are short enough: the routes are not proven, and bound_m is that of straight
/// legs. Routes are looked for within ellipsoids, tried in growing sizes. Where even four times the shortest straight
/// route does not suffice, or 10^8 expansions (10^5 whole routes with free headings), the search is stopped without an
/// answer. Lengths are those of whole legs, turns included.
FrontResult turning_front(const CorrectionGraph& graph, const TurnRule& rule, bool shortest_alone, RunContext& run);

}  // namespace alate
