#include <optional>

#include "check/leg_shape.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

/// `sign` is 1 for a climb, -1 for a descent.
RuleReport judge_slope(const Flight& flight, RuleReport report, std::optional<double> limit_rad, double sign) {
  if (!limit_rad) return report;
  for (std::size_t i = 1; i < flight.route.states.size(); ++i) {
    report.at_most({.leg = i,
                    .where = flight.route.states[i].position,
                    .value = degrees(steepest_angle_of_leg(flight.route, i, sign)),
                    .limit = degrees(*limit_rad),
                    .unit = "deg"});
  }
  return report;
}

}  // namespace

RuleReport judge_climb(const Flight& flight) {
  RuleReport report("climb");
  const auto& limit = flight.site.vehicle.climb_rad;
  if (!limit) report.not_checked("the scenario gives no climb_deg");
  return judge_slope(flight, std::move(report), limit, 1);
}

RuleReport judge_descent(const Flight& flight) {
  RuleReport report("descent");
  const auto& limit = flight.site.vehicle.descent_rad;
  if (!limit) report.not_checked("the scenario gives no descent_deg");
  return judge_slope(flight, std::move(report), limit, -1);
}

}  // namespace alate
