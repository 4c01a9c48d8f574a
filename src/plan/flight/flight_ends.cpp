#include "plan/flight/flight_ends.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

FlightStart flight_start(const Mission& mission) {
  constexpr int kHeadings = 16;
  const auto pose = [&](double heading) { return planar_pose(mission.start.x(), mission.start.y(), heading); };
  FlightStart start{.poses = {}, .label = AltitudeLabel::at(mission.start.z())};
  if (mission.heading_given) {
    start.poses.push_back(pose(kPi / 2 - mission.heading_rad));
    return start;
  }
  const Vec2 way = (mission.goal - mission.start).head<2>();
  for (int k = 0; k < kHeadings; ++k)
    start.poses.push_back(pose(std::atan2(way.y(), way.x()) + 2 * kPi * k / kHeadings));
  return start;
}

FlightEnd flight_end(const Vec3& goal, double tolerance_m) {
  constexpr double kSpare_m = 0.01;
  return {.goal = goal, .tolerance_m = std::max(0.0, tolerance_m - kSpare_m)};
}

double bin_width(double distance_m, double radius_m) {
  return std::clamp(distance_m / 250, radius_m / 2, 4 * radius_m);
}

}  // namespace alate
