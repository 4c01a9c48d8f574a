// What all planners on correction points share: when they refuse, and the way from points to a Plan.
#pragma once

#include <string>

#include "alate/plan/planner.hpp"
#include "search/label_setting/label.hpp"

namespace alate {

/// Why routes over correction points that are as short as can be are not what the problem asks for; empty if they are.
/// Turns are planned in open air alone.
std::string correction_refusal(const Problem& problem);

/// From the start through the points to the goal, as the site's turn model says.
Route route_over(const Site& site, const std::vector<CorrectionPoint>& points);

/// Length, corrections, probability of success and ids.
FrontPoint front_point(const Site& site, const CorrectionRoute& route);

}  // namespace alate
