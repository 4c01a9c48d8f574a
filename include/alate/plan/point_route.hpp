// A route told by the ids of its correction points.
#pragma once

#include <string>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// From the start over the points `503,294,...` to the goal, flown as the site's turn model says. Throws InputError,
/// its faults under `source` ("--points"), for an empty list, anything but ids between commas, ids that no correction
/// point has, and legs that are too short for their turn. The site must have navigation, or that is the fault.
Route route_over_points(const Site& site, const std::string& ids, const std::string& source);

}  // namespace alate
