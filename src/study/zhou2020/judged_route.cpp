#include "study/zhou2020/judged_route.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "space/correction_route.hpp"
#include "space/navigation_error.hpp"

namespace alate::zhou2020 {

namespace {

std::string place_of(const Route& route, std::size_t leg) {
  const auto& id = route.states[leg].point_id;
  return id ? fmt::format("at point {}", *id) : "at the goal";
}

/// "vertical error 31.2 of at most 20 units at point 295, the 3rd correction".
std::string words(const Route& route, const Violation& violation) {
  std::string rule = violation.rule;
  std::ranges::replace(rule, '_', ' ');
  return fmt::format("{} {:.4g} where {:.4g} {} is the limit, {}", rule, violation.value, violation.limit,
                     violation.unit, place_of(route, violation.leg));
}

PointKind kind_of(const Navigation& navigation, const std::optional<int>& id) {
  if (!id) return PointKind::end;
  const auto found = std::ranges::find(navigation.points, *id, &CorrectionPoint::id);
  return found == navigation.points.end() ? PointKind::end : found->kind;
}

double leg_length(const Route& route, std::size_t i) {
  const RouteState& state = route.states[i];
  return state.arc ? state.arc->radius_m * std::abs(state.arc->angle_rad) : route.segment(i).length();
}

}  // namespace

std::vector<Arrival> arrivals_of(const Site& site, const Route& route) {
  const Navigation& navigation = *site.navigation;
  std::vector<Arrival> arrivals;
  NavigationError error;
  double flown = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const double length = leg_length(route, i);
    flown += length;
    error = grown(navigation, error, length);
    const auto& id = route.states[i].point_id;
    if (!id && i + 1 < route.states.size()) continue;
    const PointKind kind = kind_of(navigation, id);
    arrivals.push_back({.where = id ? fmt::format("{}", *id) : "goal",
                        .kind = kind,
                        .flown_m = flown,
                        .vertical = error.vertical,
                        .horizontal = error.horizontal});
    error = corrected(error, kind);
  }
  return arrivals;
}

JudgedRoute judge_route(const Site& site, const std::vector<int>& ids) {
  auto [route, why] = route_through(site, ids);
  JudgedRoute judged{.broken = std::move(why)};
  if (route.empty()) return judged;
  judged.metrics = measure(site, route);
  judged.verdict = check(site, route);
  if (!judged.verdict.violations.empty()) {
    const auto first = std::ranges::min_element(judged.verdict.violations, {}, &Violation::leg);
    judged.broken = words(route, *first);
  }
  judged.arrivals = arrivals_of(site, route);
  judged.route = std::move(route);
  return judged;
}

}  // namespace alate::zhou2020
