// Where flights over real ground begin, and how fine they are searched.
#pragma once

#include "search/interval/interval_astar.hpp"

namespace alate {

/// In the heading given; else in sixteen, the first towards the goal.
FlightStart flight_start(const Mission& mission);

/// All of the goal's ball but a margin, with the usual share of it spent on altitude: degrees in a mission file and
/// their way back to metres move the last waypoint by some millimetres.
FlightEnd flight_end(const Vec3& goal, double tolerance_m);

/// Of bins and straight primitives, for a flight of `distance_m`.
double bin_width(double distance_m, double radius_m);

}  // namespace alate
