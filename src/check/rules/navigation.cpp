#include "check/corrections.hpp"
#include "check/rules.hpp"

namespace alate {

namespace {

constexpr const char* kUnit = "units";
constexpr const char* kNoNavigation = "the scenario has no navigation";

/// Calls `judge` with each visit and the errors on arrival there, every correction working.
template <class Judge>
void fly(const Flight& flight, const Judge& judge) {
  const Navigation& navigation = *flight.site.navigation;
  Errors errors;
  for (const Visit& visit : visits_of(navigation, flight.route)) {
    errors = grown(navigation, errors, visit.length_m);
    judge(visit, errors);
    if (visit.point != nullptr) errors = corrected(errors, visit.point->kind);
  }
}

RuleReport judge_error(const Flight& flight, RuleReport report, double Errors::* error,
                       double Navigation::Limits::* limit) {
  if (!flight.site.navigation) {
    report.not_checked(kNoNavigation);
    return report;
  }
  fly(flight, [&](const Visit& visit, const Errors& errors) {
    if (visit.point == nullptr) return;
    report.at_most({.leg = visit.state,
                    .where = flight.route.states[visit.state].position,
                    .value = errors.*error,
                    .limit = limits_at(*flight.site.navigation, visit.point->kind).*limit,
                    .unit = kUnit});
  });
  return report;
}

}  // namespace

RuleReport judge_vertical_error(const Flight& flight) {
  return judge_error(flight, RuleReport("vertical_error"), &Errors::vertical, &Navigation::Limits::vertical);
}

RuleReport judge_horizontal_error(const Flight& flight) {
  return judge_error(flight, RuleReport("horizontal_error"), &Errors::horizontal, &Navigation::Limits::horizontal);
}

RuleReport judge_final_error(const Flight& flight) {
  RuleReport report("final_error");
  if (!flight.site.navigation) {
    report.not_checked(kNoNavigation);
    return report;
  }
  if (flight.route.empty()) return report;
  Errors last;
  fly(flight, [&](const Visit&, const Errors& errors) { last = errors; });
  const std::size_t leg = flight.route.states.size() - 1;
  for (const double error : {last.vertical, last.horizontal}) {
    report.below({.leg = leg,
                  .where = flight.route.states.back().position,
                  .value = error,
                  .limit = flight.site.navigation->theta,
                  .unit = kUnit});
  }
  return report;
}

}  // namespace alate
