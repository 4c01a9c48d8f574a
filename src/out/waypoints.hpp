// A route as autopilots fly it: straight from waypoint to waypoint, rounding each.
#pragma once

#include "alate/core/route.hpp"

namespace alate {

/// Arcs become corners of at most 15 degrees around them: the tangents' intersections, at which an aircraft that turns
/// on the arc's circle rounds the corner on the arc itself. Where a straight leg touches an arc, no waypoint is left:
/// there is nothing to turn. Arcs in tilted planes become chords of at most 5 degrees. Straight routes stay as they
/// are.
Route waypoints_of(const Route& route);

}  // namespace alate
