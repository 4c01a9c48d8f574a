#include "alate/check/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "check/flight.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

constexpr std::array<const char*, 13> kRules{
    "terrain_clearance", "ceiling",        "threat_core",      "turn",        "climb",    "descent", "step", "bounds",
    "arrival",           "vertical_error", "horizontal_error", "final_error", "endurance"};

/// Nothing can be computed with such a state: `bounds` is broken there and the rest is left alone.
Verdict unusable(const Route& route, std::size_t state) {
  Verdict verdict{.status = Status::fail};
  const Vec3& position = route.states[state].position;
  const Vec3 where = position.unaryExpr([](double v) { return std::abs(v) <= kUnbounded ? v : 0.0; });
  verdict.violations.push_back({"bounds", state, where, -kUnbounded, 0, "m"});
  verdict.margins.push_back({"bounds", -kUnbounded, "m", state, where});
  for (const std::string_view rule : kRules) {
    if (rule == "bounds") continue;
    verdict.not_checked.push_back(
        {std::string(rule), "the route has positions or arcs that are no usable numbers", false});
  }
  return verdict;
}

Status status_of(const Verdict& verdict) {
  if (!verdict.violations.empty()) return Status::fail;
  const bool unknown = std::ranges::any_of(verdict.not_checked, &NotChecked::unknown);
  return unknown ? Status::unknown : Status::pass;
}

}  // namespace

const char* to_string(Status status) {
  switch (status) {
    case Status::pass:
      return "pass";
    case Status::fail:
      return "fail";
    case Status::unknown:
      return "unknown";
  }
  return "";
}

Verdict check(const Site& site, const Route& route) {
  if (const auto state = first_unusable_state(route)) return unusable(route, *state);
  const Flight flight(site, route);
  Verdict verdict;
  for (const auto judge : {judge_terrain_clearance, judge_ceiling, judge_threat_core, judge_turn, judge_climb,
                           judge_descent, judge_step, judge_bounds, judge_arrival, judge_vertical_error,
                           judge_horizontal_error, judge_final_error, judge_endurance}) {
    judge(flight).enter(verdict);
  }
  verdict.status = status_of(verdict);
  return verdict;
}

}  // namespace alate
