#include "space/dubins/planar_pose.hpp"

#include <cmath>

namespace alate {

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2 * kPi); }

PlanarPose planar_pose(double x, double y, double heading_rad) {
  const double heading = wrapped(heading_rad);
  return {.x = x, .y = y, .heading = heading, .cos = std::cos(heading), .sin = std::sin(heading)};
}

PlanarPose reversed(const PlanarPose& pose) {
  const double heading = pose.heading > 0 ? pose.heading - kPi : pose.heading + kPi;
  return {.x = pose.x, .y = pose.y, .heading = heading, .cos = -pose.cos, .sin = -pose.sin};
}

PlanarMotion planar_motion(Steering steering, double length_m, double radius_m) {
  if (steering == Steering::straight) return {.chord_m = length_m};
  const double turn = static_cast<double>(steering) * length_m / radius_m;
  return {.chord_m = 2 * radius_m * std::sin(std::abs(turn) / 2),
          .half_cos = std::cos(turn / 2),
          .half_sin = std::sin(turn / 2),
          .turn_rad = turn};
}

PlanarPose moved(const PlanarPose& from, const PlanarMotion& motion) {
  const double x = from.x + motion.chord_m * (from.cos * motion.half_cos - from.sin * motion.half_sin);
  const double y = from.y + motion.chord_m * (from.sin * motion.half_cos + from.cos * motion.half_sin);
  if (motion.turn_rad == 0) return {.x = x, .y = y, .heading = from.heading, .cos = from.cos, .sin = from.sin};
  return planar_pose(x, y, from.heading + motion.turn_rad);
}

}  // namespace alate
