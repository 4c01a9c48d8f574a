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

/// What the last leg with any length leaves for the next turn.
struct Approach {
  Vec3 direction;
  double room_m = 0;  ///< Part of the leg that the turn may use.
  bool arc = false;
};

double available_radius(double turn_rad, double room_m) {
  if (turn_rad < kNoTurn) return kUnbounded;
  return std::min(kUnbounded, room_m / std::tan(turn_rad / 2));
}

/// The smallest radius, and whether turns are changes of heading in space or in the plane.
struct Limit {
  double radius_m = 0;
  bool in_space = false;
};

bool is_tilted(const RouteState& state) { return state.arc && state.arc->plane; }

/// The larger radius where both the vehicle and its navigation have one.
std::optional<Limit> limit_of(const Flight& flight) {
  const auto& navigation = flight.site.navigation;
  const bool turns = navigation && navigation->turn_model != TurnModel::none && navigation->turn_radius_m > 0;
  const auto& radius = flight.site.vehicle.turn_radius_m;
  if (!turns && !radius) return std::nullopt;
  return Limit{.radius_m = std::max(radius.value_or(0), turns ? navigation->turn_radius_m : 0),
               .in_space = turns || std::ranges::any_of(flight.route.states, is_tilted)};
}

double length_of(const Route& route, std::size_t i, const Limit& limit) {
  return limit.in_space ? length_of_leg(route, i) : planar_length_of_leg(route, i);
}

/// Judges the turn from `before` into leg `i`.
double joint_radius(const Approach& before, const Route& route, std::size_t i, const Limit& limit) {
  const Vec3 after = first_direction(route, i);
  const double turn = limit.in_space ? angle_between(before.direction, after) : turn_between(before.direction, after);
  const bool arc = before.arc || route.states[i].arc;
  if (arc) return turn < kTangent ? kUnbounded : 0;
  return available_radius(turn, std::min(before.room_m, length_of(route, i, limit) / 2));
}

/// An arc that misses its ends is broken even where no radius is asked for: it is not flown as it is measured.
void judge_arc(const Route& route, std::size_t i, const std::optional<Limit>& limit, RuleReport& report) {
  const auto& arc = route.states[i].arc;
  if (!arc) return;
  const bool misses = arc_gap(route, i) > kRoundingNoise;
  if (!misses && !limit) return;
  report.at_least({.leg = i,
                   .where = route.states[i].position,
                   .value = misses ? 0 : arc->radius_m,
                   .limit = limit ? limit->radius_m : arc->radius_m});
}

}  // namespace

RuleReport judge_turn(const Flight& flight) {
  RuleReport report("turn");
  const auto limit = limit_of(flight);
  if (!limit) report.not_checked("the scenario gives no turn_radius_m");
  const Route& route = flight.route;
  const Mission& mission = flight.site.mission;
  std::optional<Approach> before;
  if (mission.heading_given) before = Approach{direction_of(mission.heading_rad), kUnbounded, false};
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    judge_arc(route, i, limit, report);
    const double length = limit ? length_of(route, i, *limit) : 0;
    if (length <= kRoundingNoise) continue;
    const double radius = before ? joint_radius(*before, route, i, *limit) : kUnbounded;
    report.at_least({.leg = i, .where = route.states[i - 1].position, .value = radius, .limit = limit->radius_m});
    before = Approach{last_direction(route, i), length / 2, route.states[i].arc.has_value()};
  }
  return report;
}

}  // namespace alate
