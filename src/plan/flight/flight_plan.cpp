#include "plan/flight/flight_plan.hpp"

#include <fmt/core.h>

#include "alate/core/along_route.hpp"
#include "plan/flight/flight_bound.hpp"
#include "space/lower_bound.hpp"

namespace alate {

Plan begin_flight(const Site& site, const RunContext& run) {
  const Mission& mission = site.mission;
  Plan plan{.lower_bound = physical_bound(site, mission.start), .seed = run.seed()};
  if ((mission.goal - mission.start).norm() <= mission.tolerance_m) {
    plan.outcome = Outcome::feasible;
    plan.route.states = {{.position = mission.start, .leg = LegKind::start}};
  }
  return plan;
}

void keep_if_better(const Site& site, Route route, double cost, Plan& plan) {
  const double length_m = flown_length(route);
  const auto& range_m = site.vehicle.range_m;
  if (range_m && length_m > *range_m) {
    if (plan.route.empty())
      plan.why =
          fmt::format("a route was found, but it is {:.0f} m long, and vehicle.range_m is {:.0f}", length_m, *range_m);
    return;
  }
  if (!plan.route.empty() && cost >= plan.cost) return;
  plan.outcome = Outcome::feasible;
  plan.route = std::move(route);
  plan.cost = cost;
  plan.why.clear();
}

void conclude_flight(Plan& plan, const RunContext& run, std::string_view nothing) {
  plan.counters["iterations"] = run.iterations();
  plan.stop = run.stop();
  const bool stopped = plan.stop == Stop::deadline || plan.stop == Stop::cancelled;
  plan.reproducible = !stopped;
  if (plan.route.empty() && plan.why.empty()) plan.why = stopped ? "stopped before any route was found" : nothing;
}

Plan plan_flight(const Problem& problem, RunContext& run, std::string_view nothing,
                 const std::function<void(Plan&)>& fly) {
  Plan plan = begin_flight(problem.world.site(), run);
  if (plan.route.empty()) {
    note_barrier(problem, run, plan);
    if (plan.outcome != Outcome::infeasible_proven) fly(plan);
  }
  conclude_flight(plan, run, nothing);
  return plan;
}

}  // namespace alate
