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

/// One end of the flight as it was given.
struct GivenEnd {
  const PlaceSpec& by_scenario;
  const std::optional<GivenPoint>& by_points;
  const char* field;  ///< "start" or "goal".
};

/// Where the flight begins or ends: by the points, or else by the scenario. Both may say it within 1 m of each other.
/// Nothing, and a fault, if neither does.
std::optional<Vec3> locate_end(const Site& site, const GivenEnd& given, SiteFaults& faults);

}  // namespace alate
