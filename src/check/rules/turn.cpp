#include <algorithm>
#include <cmath>
#include <optional>

#include "check/leg_shape.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

/// Radians; less is no turn.
constexpr double kNoTurn = 1e-9;

/// Radians by which an arc may meet its neighbour: what rounding of positions by kRoundingNoise does on 1 m.
constexpr double kTangent = 1e-6;

/// What the last leg with planar length leaves for the next turn.
struct Approach {
  Vec3 direction;
  double room_m = 0;  ///< Part of the leg that the turn may use.
  bool arc = false;
};

double available_radius(double turn_rad, double room_m) {
  if (turn_rad < kNoTurn) return kUnbounded;
  return std::min(kUnbounded, room_m / std::tan(turn_rad / 2));
}

/// Judges the turn from `before` into leg `i`.
double joint_radius(const Approach& before, const Route& route, std::size_t i) {
  const double turn = turn_between(before.direction, first_direction(route, i));
  const bool arc = before.arc || route.states[i].arc;
  if (arc) return turn < kTangent ? kUnbounded : 0;
  return available_radius(turn, std::min(before.room_m, planar_length_of_leg(route, i) / 2));
}

}  // namespace

RuleReport judge_turn(const Flight& flight) {
  RuleReport report("turn");
  const auto& radius = flight.site.vehicle.turn_radius_m;
  if (!radius) {
    report.not_checked("the scenario gives no turn_radius_m");
    return report;
  }
  const Route& route = flight.route;
  const Mission& mission = flight.site.mission;
  std::optional<Approach> before;
  if (mission.heading_given) before = Approach{direction_of(mission.heading_rad), kUnbounded, false};
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const double length = planar_length_of_leg(route, i);
    if (length <= kRoundingNoise) continue;
    const Vec3& joint = route.states[i - 1].position;
    const double room = before ? joint_radius(*before, route, i) : kUnbounded;
    report.at_least({.leg = i, .where = joint, .value = room, .limit = *radius});
    if (const auto& arc = route.states[i].arc) {
      const double own = arc_gap(route, i) > kRoundingNoise ? 0 : arc->radius_m;
      report.at_least({.leg = i, .where = route.states[i].position, .value = own, .limit = *radius});
    }
    before = Approach{last_direction(route, i), length / 2, route.states[i].arc.has_value()};
  }
  return report;
}

}  // namespace alate
