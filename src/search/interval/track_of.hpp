// From a route back to a track.
#pragma once

#include "alate/core/route.hpp"
#include "space/flight/track.hpp"

namespace alate {

/// The ground track of a route for an aircraft of this radius: its arcs and straight legs where they are of that radius
/// and touch, Dubins paths from leg to leg where they do not.
Track track_of(const Route& route, double radius_m);

}  // namespace alate
