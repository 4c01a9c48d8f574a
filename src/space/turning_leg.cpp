#include "space/turning_leg.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// Directions that differ by less are the same: rounding of frame positions does as much.
constexpr double kParallel = 1e-12;

/// Unit vector across `heading` in the level plane, to the left of it.
Vec3 left_of(const Vec3& heading) {
  const Vec3 left = Vec3::UnitZ().cross(heading);
  const double length = left.norm();
  return length > kParallel ? Vec3(left / length) : Vec3(-Vec3::UnitX());
}

/// Part of `v` across the unit vector `heading`; taken off twice, for `v` may be nearly parallel to it.
Vec3 across_part(const Vec3& v, const Vec3& heading) {
  const Vec3 once = v - heading.dot(v) * heading;
  return once - heading.dot(once) * heading;
}

Turn turn_towards(const Pose& from, const Vec3& side, double radius_m) {
  return {.center = from.position + radius_m * side, .normal = from.heading.cross(side), .angle_rad = 0};
}

/// tan(angle / 2) of the turn between two unit vectors, exact for small turns; infinite for a reversal.
double half_tangent(const Vec3& before, const Vec3& after) { return (after - before).norm() / (after + before).norm(); }

/// The turn from `before` to `after` with tangent length `corner_m`, the distance of its ends to their tangents'
/// meeting point.
Turn corner_turn(const Pose& before, const Vec3& after, double corner_m, double radius_m) {
  const Vec3 across = across_part(after, before.heading);
  const double length = across.norm();
  if (length <= kParallel) return {};
  Turn turn = turn_towards(before, across / length, radius_m);
  turn.angle_rad = 2 * std::atan(corner_m / radius_m);
  return turn;
}

}  // namespace

std::optional<TurningLeg> straight_leg(const Vec3& from, const Vec3& to) {
  const Vec3 chord = to - from;
  const double distance = chord.norm();
  if (!(distance > 0)) return std::nullopt;
  return TurningLeg{
      .leave = {}, .straight_m = distance, .arrive = {}, .length_m = distance, .heading = chord / distance};
}

std::optional<TurningLeg> arc_tangent_leg(const Pose& from, const Vec3& to, double radius_m) {
  const Vec3 chord = to - from.position;
  const double along = from.heading.dot(chord);
  Vec3 side = across_part(chord, from.heading);
  const double distance = chord.norm();
  double across = side.norm();
  if (across <= kParallel * distance) {
    if (along >= 0) return straight_leg(from.position, to);
    side = left_of(from.heading);
    across = 0;
  } else {
    side /= across;
  }
  const double squared = distance * distance - 2 * radius_m * across;
  if (!(squared > 0)) return std::nullopt;
  const double straight = std::sqrt(squared);
  // For a point ahead, along - straight is a difference of near equals; this form of it keeps its sign.
  const double excess = along > 0 ? across * (2 * radius_m - across) / (along + straight) : along - straight;
  double angle = std::atan2(radius_m * excess + straight * across, straight * along - radius_m * (across - radius_m));
  // A turn to a point behind takes more than a quarter of the circle.
  if (angle < 0 || (along < 0 && angle < 1)) angle += 2 * kPi;
  TurningLeg leg{.leave = turn_towards(from, side, radius_m), .straight_m = straight, .arrive = {}, .heading = {}};
  leg.leave.angle_rad = std::min(angle, std::nextafter(2 * kPi, 0.0));
  leg.length_m = std::max(straight + radius_m * angle, distance);
  leg.heading = (std::cos(angle) * from.heading + std::sin(angle) * side).normalized();
  return leg;
}

std::optional<TurningLeg> free_heading_leg(const Pose& from, const Pose& to, double radius_m) {
  constexpr int kMostSteps = 60;
  constexpr double kSettled = 1e-12;
  const double distance = (to.position - from.position).norm();
  double leave = 0;
  double arrive = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec3 between = to.position - arrive * to.heading - from.position - leave * from.heading;
    const double length = between.norm();
    if (!(length > leave + arrive)) return std::nullopt;
    const Vec3 direction = between / length;
    const double next_leave = radius_m * half_tangent(from.heading, direction);
    const double next_arrive = radius_m * half_tangent(direction, to.heading);
    const double moved = std::abs(next_leave - leave) + std::abs(next_arrive - arrive);
    leave = next_leave;
    arrive = next_arrive;
    if (moved > kSettled * distance) continue;
    const double straight = length - leave - arrive;
    if (straight <= kSettled * distance) return std::nullopt;
    TurningLeg leg{.leave = corner_turn(from, direction, leave, radius_m),
                   .straight_m = straight,
                   .arrive = {},
                   .heading = to.heading};
    const Pose before_arrival{to.position - arrive * (direction + to.heading), direction};
    leg.arrive = corner_turn(before_arrival, to.heading, arrive, radius_m);
    leg.length_m = std::max(straight + radius_m * (leg.leave.angle_rad + leg.arrive.angle_rad), distance);
    return leg;
  }
  return std::nullopt;
}

Vec3 position_on(const Turn& turn, const Vec3& from, double angle_rad) {
  if (turn.angle_rad == 0) return from;
  const Vec3 out = from - turn.center;
  return turn.center + std::cos(angle_rad) * out + std::sin(angle_rad) * turn.normal.cross(out);
}

}  // namespace alate
