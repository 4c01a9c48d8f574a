// A route as autopilots fly it: straight from waypoint to waypoint, rounding each.
#pragma once

#include "alate/core/route.hpp"

namespace alate {

/// Arcs become corners of at most `corner_rad` around them: the tangents' intersections, at which an aircraft that
/// turns on the arc's circle rounds the corner on the arc itself. Where a leg touches an arc, a waypoint is left only
/// if the height bends there: there is nothing to turn. Arcs in tilted planes become chords of at most 5 degrees.
/// Straight routes stay as they are.
Route waypoints_of(const Route& route, double corner_rad);

}  // namespace alate
