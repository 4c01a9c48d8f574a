// Limits of the aircraft on routes of straight legs, by the rules of `check`.
#pragma once

#include <optional>

#include "alate/data/site.hpp"

namespace alate {

/// Climb and descent angles of legs, and corners: the arc of the smallest radius that rounds a corner may use half of
/// the shorter leg beside it (seen from above).
class StraightLimits {
 public:
  explicit StraightLimits(const Site& site);

  /// Is the leg flat enough?
  bool allows(const Vec3& leg) const;
  /// May the second of two legs follow the first?
  bool allows_corner(const Vec3& before, const Vec3& after) const;
  /// May the flight begin with this leg? Only a heading that the scenario gives asks anything.
  bool allows_first(const Vec3& leg) const;
  /// Do corners ask anything?
  bool minds_turns() const { return radius_m_.has_value(); }
  /// The steepest climb and the steepest descent as rise over planar length, the lesser of the two; at most `most`.
  double slope(double most) const;

 private:
  std::optional<double> climb_rad_, descent_rad_, radius_m_;
  std::optional<Vec3> heading_;  ///< Unit.
};

}  // namespace alate
