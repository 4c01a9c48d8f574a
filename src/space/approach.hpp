// How much farther the goal is than it looks, for an aircraft that cannot turn on the spot.
#pragma once

#include "alate/core/geometry.hpp"

namespace alate {

/// Detour to reach `offset` (goal minus position) from `direction` on one turn of `radius_m` and a straight line,
/// minus the straight distance, in the plane. Where the goal is inside the turning circle by more than the tolerance,
/// the aircraft first flies straight on until it no longer is.
/// Dubins 1957, for a free heading at the end. Faded out between 2 and 4 radii, where terrain and threats say more
/// about the right heading than the goal does. A guide for the last turns, no bound.
double approach_detour(const Vec2& offset, const Vec2& direction, double radius_m, double tolerance_m);

}  // namespace alate
