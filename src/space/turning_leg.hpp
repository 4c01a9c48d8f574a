// Legs in space that turn on circles of one radius (Zhou et al. 2020, problem 2).
#pragma once

#include <optional>

#include "alate/core/geometry.hpp"

namespace alate {

/// Where the aircraft is and where it heads: a unit vector.
struct Pose {
  Vec3 position;
  Vec3 heading;
};

/// Part of a circle in any plane. Without an angle there is no turn, and centre and normal mean nothing.
struct Turn {
  Vec3 center = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< Unit; seen against it the turn is counter-clockwise.
  double angle_rad = 0;         ///< In [0, 2 pi).
};

/// Turn, straight piece, turn.
struct TurningLeg {
  Turn leave;
  double straight_m = 0;
  Turn arrive;
  double length_m = 0;  ///< Turns included; never less than the straight line between the ends.
  Vec3 heading;         ///< On arrival, unit.
};

/// A leg without turns. Nothing if the points coincide.
std::optional<TurningLeg> straight_leg(const Vec3& from, const Vec3& to);

/// Turns in the plane of heading and `to` until the heading points at `to`, then flies straight: the contest's model.
/// A point straight behind has no such plane: the turn is level then, to the left; a vertical heading counts as north
/// there. Nothing if `to` lies within the circle of the turn or on it, d <= 2 r sin(angle), or is where we are.
std::optional<TurningLeg> arc_tangent_leg(const Pose& from, const Vec3& to, double radius_m);

/// Turn, straight piece and turn between given headings, each turn below half a circle in its own plane. Found by
/// fixed-point iteration on the corners, where the tangents of each turn meet; it converges where the points lie some
/// radii apart. Nothing if it does not, or if the turns leave no room for a straight piece. There may be shorter
/// curves: only the straight line is a proven lower bound.
std::optional<TurningLeg> free_heading_leg(const Pose& from, const Pose& to, double radius_m);

/// Position after `angle_rad` of the turn that begins at `from`.
Vec3 position_on(const Turn& turn, const Vec3& from, double angle_rad);

}  // namespace alate
