// Correction points told by their ids.
#pragma once

#include <string>
#include <vector>

#include "alate/data/site.hpp"

namespace alate {

/// The ids of `503,294,...`. Throws InputError, its faults under `source` ("--points"), for an empty list, anything but
/// ids between commas, and ids that no correction point has: the nearest ones are named. The site must have navigation,
/// or that is the fault.
std::vector<int> read_point_ids(const Site& site, const std::string& ids, const std::string& source);

}  // namespace alate
