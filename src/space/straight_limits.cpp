#include "space/straight_limits.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// Radians that rounding may put a leg beyond its limit.
constexpr double kHair_rad = 1e-12;

/// Radius of the arc that rounds a corner, its tangents `room_m` long.
bool has_room(double turn_rad, double room_m, double radius_m) {
  return radius_m * std::tan(turn_rad / 2) <= room_m && turn_rad < kPi;
}

}  // namespace

StraightLimits::StraightLimits(const Site& site)
    : climb_rad_(site.vehicle.climb_rad),
      descent_rad_(site.vehicle.descent_rad),
      radius_m_(site.vehicle.turn_radius_m) {
  if (site.mission.heading_given) heading_ = direction_of(site.mission.heading_rad);
}

bool StraightLimits::allows(const Vec3& leg) const {
  const double climb = climb_angle({Vec3::Zero(), leg});
  const bool too_steep_up = climb_rad_ && climb > *climb_rad_ + kHair_rad;
  const bool too_steep_down = descent_rad_ && -climb > *descent_rad_ + kHair_rad;
  return !too_steep_up && !too_steep_down;
}

bool StraightLimits::allows_corner(const Vec3& before, const Vec3& after) const {
  if (!radius_m_) return true;
  const double room = std::min(before.head<2>().norm(), after.head<2>().norm()) / 2;
  return has_room(turn_between(before, after), room, *radius_m_);
}

bool StraightLimits::allows_first(const Vec3& leg) const {
  if (!radius_m_ || !heading_) return true;
  return has_room(turn_between(*heading_, leg), leg.head<2>().norm() / 2, *radius_m_);
}

double StraightLimits::slope(double most) const {
  for (const auto& limit : {climb_rad_, descent_rad_})
    if (limit && *limit < kPi / 2) most = std::min(most, std::tan(*limit));
  return most;
}

}  // namespace alate
