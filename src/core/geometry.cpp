#include "alate/core/geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alate {

double heading_of(const Vec3& direction) {
  if (direction.x() == 0 && direction.y() == 0) return 0;
  const double heading = std::atan2(direction.x(), direction.y());
  return heading < 0 ? heading + 2 * kPi : heading;
}

Vec3 direction_of(double heading_rad) { return {std::sin(heading_rad), std::cos(heading_rad), 0}; }

double climb_angle(const Segment& leg) { return std::atan2(leg.b.z() - leg.a.z(), leg.planar_length()); }

double turn_between(const Vec3& before, const Vec3& after) {
  const double cross = before.x() * after.y() - before.y() * after.x();
  const double dot = before.head<2>().dot(after.head<2>());
  return std::abs(std::atan2(cross, dot));
}

double angle_between(const Vec3& before, const Vec3& after) {
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

double closest_parameter(const Segment& leg, const Vec3& point) {
  const Vec3 along = leg.b - leg.a;
  const double squared = along.squaredNorm();
  if (squared == 0) return 0;
  return std::clamp((point - leg.a).dot(along) / squared, 0.0, 1.0);
}

}  // namespace alate
