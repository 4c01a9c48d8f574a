#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "check/leg_shape.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

/// Radians; less is no turn.
constexpr double kNoTurn = 1e-9;

/// Radians by which an arc may meet its neighbour: what rounding of positions by kRoundingNoise does on 1 m.
constexpr double kTangent = 1e-6;

/// A leg with any length, and how far the corners at its ends reach along it: metres for each metre of radius.
struct CorneredLeg {
  std::size_t index = 0;
  double length_m = 0;
  bool arc = false;
  double begin_reach = 0;
  double end_reach = 0;

  /// Of the largest circle that rounds both corners, arcs apart.
  double radius() const {
    const double reach = begin_reach + end_reach;
    return arc || reach == 0 ? kUnbounded : std::min(kUnbounded, length_m / reach);
  }
};

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

double turn_of(const Vec3& before, const Vec3& after, const Limit& limit) {
  const double turn = limit.in_space ? angle_between(before, after) : turn_between(before, after);
  return turn < kNoTurn ? 0 : turn;
}

/// The corner between two legs, on both of them; an arc must be met without one.
void note_corner(const Route& route, const Limit& limit, CorneredLeg& before, CorneredLeg& after) {
  const double turn = turn_of(last_direction(route, before.index), first_direction(route, after.index), limit);
  const bool smooth = (before.arc || after.arc) && turn < kTangent;
  before.end_reach = after.begin_reach = smooth ? 0 : std::tan(turn / 2);
}

/// The legs with any length, and their corners, the one from the start's heading included.
std::vector<CorneredLeg> legs_of(const Flight& flight, const Limit& limit) {
  const Route& route = flight.route;
  std::vector<CorneredLeg> legs;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const double length = length_of(route, i, limit);
    if (!(length <= kRoundingNoise)) legs.push_back({i, length, route.states[i].arc.has_value()});
  }
  if (legs.empty()) return legs;
  const Mission& mission = flight.site.mission;
  if (mission.heading_given) {
    const Vec3 first = first_direction(route, legs.front().index);
    const double turn = turn_of(direction_of(mission.heading_rad), first, limit);
    legs.front().begin_reach = legs.front().arc && turn < kTangent ? 0 : std::tan(turn / 2);
  }
  for (std::size_t k = 1; k < legs.size(); ++k) note_corner(route, limit, legs[k - 1], legs[k]);
  return legs;
}

/// Of the corner into leg k: what both its legs have room for, nothing where one of them is an arc.
double corner_radius(const std::vector<CorneredLeg>& legs, std::size_t k) {
  const CorneredLeg& leg = legs[k];
  const bool first = k == 0;
  if (leg.begin_reach == 0) return kUnbounded;
  if (leg.arc || (!first && legs[k - 1].arc)) return 0;
  return first ? leg.radius() : std::min(legs[k - 1].radius(), leg.radius());
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
  const std::vector<CorneredLeg> legs = limit ? legs_of(flight, *limit) : std::vector<CorneredLeg>{};
  std::size_t k = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    judge_arc(route, i, limit, report);
    if (k == legs.size() || legs[k].index != i) continue;
    const double radius = corner_radius(legs, k++);
    report.at_least({.leg = i, .where = route.states[i - 1].position, .value = radius, .limit = limit->radius_m});
  }
  return report;
}

}  // namespace alate
