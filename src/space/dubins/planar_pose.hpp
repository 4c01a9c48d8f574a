// Where an aircraft is and where it heads, seen from above, and how it moves on.
#pragma once

#include "alate/core/geometry.hpp"

namespace alate {

/// Angle in [-pi, pi] that differs from `angle_rad` by whole turns.
double wrapped(double angle_rad);

/// Position in metres, heading counter-clockwise from +x in [-pi, pi], and its cosine and sine. Made by `planar_pose`
/// and `reversed` only, so that the three agree to rounding.
struct PlanarPose {
  double x = 0;
  double y = 0;
  double heading = 0;
  double cos = 1;
  double sin = 0;

  Vec2 position() const { return {x, y}; }
  Vec2 direction() const { return {cos, sin}; }
};

/// Any finite heading, in radians.
PlanarPose planar_pose(double x, double y, double heading_rad);

/// The same place, the other way round.
PlanarPose reversed(const PlanarPose& pose);

/// What the aircraft does on a piece of its way.
enum class Steering : signed char { right = -1, straight = 0, left = 1 };

/// A piece of way seen from where it begins: of use where the same piece is flown from many poses.
struct PlanarMotion {
  double chord_m = 0;   ///< From begin to end; negative after more than a full turn, for the chord points back then.
  double half_cos = 1;  ///< Of the angle from the heading at the begin to the chord, half the turn.
  double half_sin = 0;
  double turn_rad = 0;  ///< Positive to the left.
};

/// `length_m` >= 0 on a circle of `radius_m`, or straight.
PlanarMotion planar_motion(Steering steering, double length_m, double radius_m);

/// The pose after the motion; exact but for rounding, however long the chain of motions.
PlanarPose moved(const PlanarPose& from, const PlanarMotion& motion);

}  // namespace alate
