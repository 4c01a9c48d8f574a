// Correction points of a scenario, read and brought into the frame.
#pragma once

#include "alate/data/site.hpp"
#include "data/given_points.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// The points of the scenario's file or list, as they stand there; none if it has no `navigation`.
GivenPoints read_points(const Scenario& scenario, SiteFaults& faults);

/// `navigation` with its points in the frame.
Navigation navigation_of(const Site& site, const GivenPoints& given, SiteFaults& faults);

/// Where the flight begins or ends: by the points, or else by the scenario. Both may say it within 1 m of each other.
/// Nothing, and a fault at `field`, if neither does.
std::optional<Vec3> locate_end(const Site& site, const PlaceSpec& place, const std::optional<GivenPoint>& given,
                               const std::string& field, SiteFaults& faults);

}  // namespace alate
