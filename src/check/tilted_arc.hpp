// An arc in a tilted plane: where it is, how steep, how it rises and falls.
#pragma once

#include <optional>
#include <vector>

#include "alate/core/route.hpp"
#include "check/level_band.hpp"

namespace alate {

/// Climb and descent along a leg, both positive, metres.
struct Rise {
  double up_m = 0;
  double down_m = 0;
};

/// The arc as center + radius (cos(s) out + sin(s) along), s from 0 to its angle.
struct TiltedArc {
  Vec3 center;
  Vec3 out;    ///< Unit, towards the foot of the state before the arc on its plane.
  Vec3 along;  ///< Unit, direction of flight where it begins.
  double radius_m;
  double angle_rad;

  Vec3 at(double s) const;
  Vec3 direction(double s) const;
  /// Largest angle to the horizontal, upwards for `sign` 1 and downwards for -1; negative if it only goes the other
  /// way.
  double steepest(double sign) const;
  Rise rise() const;
  /// Parts of the arc, as shares of its angle, that lie within [floor, top].
  std::vector<Part> parts_between(double floor, double top) const;
};

/// Nothing for straight legs, and for arcs that are level or climb about an upright axis.
std::optional<TiltedArc> tilted_arc(const Route& route, std::size_t i);

}  // namespace alate
