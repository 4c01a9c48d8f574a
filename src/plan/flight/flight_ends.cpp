#include "plan/flight/flight_ends.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

FlightStart flight_start(const Mission& mission) {
  const Vec2 at = mission.start.head<2>();
  const AltitudeLabel label = AltitudeLabel::at(mission.start.z());
  if (!mission.heading_given) return {any_heading(at, mission.goal.head<2>()), label};
  return {{planar_pose(at.x(), at.y(), kPi / 2 - mission.heading_rad)}, label};
}

FlightEnd flight_end(const Vec3& goal, double tolerance_m) {
  constexpr double kSpare_m = 0.01;
  return {.goal = goal, .tolerance_m = std::max(0.0, tolerance_m - kSpare_m)};
}

double bin_width(double distance_m, double radius_m) {
  return std::clamp(distance_m / 250, radius_m / 2, 4 * radius_m);
}

}  // namespace alate
