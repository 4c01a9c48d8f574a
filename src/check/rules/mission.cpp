#include "check/corrections.hpp"
#include "check/leg_shape.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

constexpr double kStartTolerance = 1;

}  // namespace

/// Is each correction point where the route says that it is?
void judge_points(const Flight& flight, RuleReport& report) {
  for (const Visit& visit : visits_of(*flight.site.navigation, flight.route)) {
    const RouteState& state = flight.route.states[visit.state];
    if (visit.point == nullptr && !visit.unknown) continue;
    const double missed = visit.unknown ? kUnbounded : (state.position - visit.point->position).norm();
    if (missed > kRoundingNoise) report.at_most({.leg = visit.state, .where = state.position, .value = missed});
  }
}

RuleReport judge_arrival(const Flight& flight) {
  RuleReport report("arrival");
  const Mission& mission = flight.site.mission;
  const auto& states = flight.route.states;
  const Vec3 first = states.empty() ? mission.start : states.front().position;
  const Vec3 last = states.empty() ? mission.start : states.back().position;
  const double missed_start = (first - mission.start).norm();
  if (missed_start > kStartTolerance) {
    report.at_most({.leg = 0, .where = first, .value = missed_start, .limit = kStartTolerance});
  }
  if (flight.site.navigation) judge_points(flight, report);
  report.at_most({.leg = states.empty() ? 0 : states.size() - 1,
                  .where = last,
                  .value = states.empty() ? kUnbounded : (last - mission.goal).norm(),
                  .limit = mission.tolerance_m});
  return report;
}

RuleReport judge_endurance(const Flight& flight) {
  RuleReport report("endurance");
  const auto& range = flight.site.vehicle.range_m;
  if (!range) report.not_checked("the scenario gives no range_m");
  if (!range || flight.route.empty()) return report;
  const std::size_t last = flight.route.states.size() - 1;
  double length = 0;
  for (std::size_t i = 1; i <= last; ++i) length += length_of_leg(flight.route, i);
  report.at_most({.leg = last, .where = flight.route.states.back().position, .value = length, .limit = *range});
  return report;
}

}  // namespace alate
