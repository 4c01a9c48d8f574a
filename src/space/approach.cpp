#include "space/approach.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// Angle in [0, 2 pi); rounding just below zero is zero.
double turn_angle(double angle) {
  constexpr double kRounding = 1e-9;
  return angle < -kRounding ? angle + 2 * kPi : std::max(0.0, angle);
}

/// Length to the point `ahead` before and `aside` beside the aircraft, `aside` >= 0.
double turning_length(double ahead, double aside, double radius, double tolerance) {
  const double to_center = std::hypot(ahead, radius - aside);
  if (to_center >= radius) {
    const double turn = turn_angle(std::atan2(ahead, radius - aside) - std::acos(radius / to_center));
    return radius * turn + std::sqrt(to_center * to_center - radius * radius);
  }
  if (radius - to_center <= tolerance) return radius * turn_angle(std::atan2(ahead, radius - aside));
  const double half_chord = std::sqrt(radius * radius - (radius - aside) * (radius - aside));
  return ahead + half_chord + radius * turn_angle(std::atan2(-half_chord, radius - aside));
}

}  // namespace

double approach_detour(const Vec2& offset, const Vec2& direction, double radius_m, double tolerance_m) {
  const double distance = offset.norm();
  const double weight = std::clamp((4 * radius_m - distance) / (2 * radius_m), 0.0, 1.0);
  const double planar = direction.norm();
  if (distance <= tolerance_m || weight <= 0 || planar <= 0) return 0;
  const double ahead = offset.dot(direction) / planar;
  const double aside = std::abs(direction.x() * offset.y() - direction.y() * offset.x()) / planar;
  return weight * std::max(0.0, turning_length(ahead, aside, radius_m, tolerance_m) - distance);
}

}  // namespace alate
