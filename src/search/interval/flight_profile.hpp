// From a track to a route: altitudes by a taut string through the band or a part of it, legs where it bends.
#pragma once

#include <optional>

#include "alate/core/route.hpp"
#include "search/interval/interval_astar.hpp"

namespace alate {

/// The route over a track with the least length and ascent, or one that threats see less of where that is cheaper;
/// nothing where no altitude profile keeps the band (no track of `IntervalAStar` or `FlightPath` is such).
std::optional<Route> fly_track(const FlightCost& cost, const Track& track, const Vec3& start, const FlightEnd& end);

}  // namespace alate
