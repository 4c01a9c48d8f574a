// A route told by the ids of its correction points.
#pragma once

#include <string>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Straight legs from the start over the points `503,294,...` to the goal. Throws InputError, its faults under `source`
/// ("--points"), for an empty list, anything but ids between commas, and ids that no correction point has: the nearest
/// ones are named. The site must have navigation, or that is the fault.
Route route_over_points(const Site& site, const std::string& ids, const std::string& source);

}  // namespace alate
