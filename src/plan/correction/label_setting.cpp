#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "plan/correction/correction_plan.hpp"
#include "plan/correction/correction_planners.hpp"
#include "search/label_setting/chance_front.hpp"
#include "search/label_setting/gap.hpp"
#include "search/label_setting/shortest.hpp"
#include "search/turning/turning_front.hpp"

namespace alate {

namespace {

/// What the problem prefers of `front`, an index: ties go to the shorter, then to fewer corrections, then to the surer.
std::size_t preferred(const std::vector<FrontPoint>& front, Preference prefer) {
  const auto rank = [&](const FrontPoint& one) {
    const double corrections = one.corrections;
    if (prefer == Preference::corrections) return std::array{corrections, one.length_m, -one.probability};
    if (prefer == Preference::probability) return std::array{-one.probability, one.length_m, corrections};
    return std::array{one.length_m, corrections, -one.probability};
  };
  return static_cast<std::size_t>(std::ranges::min_element(front, {}, rank) - front.begin());
}

/// Without routes that the aircraft's range does not allow.
FrontResult within_range(const Problem& problem, FrontResult found) {
  const double most = problem.vehicle.range_m.value_or(kInfinity);
  const auto too_long = [&](const CorrectionRoute& route) { return route.length_m > most; };
  std::erase_if(found.routes, too_long);
  if (found.best && too_long(*found.best)) found.best.reset();
  return found;
}

FrontResult search(const Problem& problem, const CorrectionGraph& graph, RunContext& run) {
  const bool alone = !problem.front && problem.prefer == Preference::length;
  if (graph.limits().turn_model != TurnModel::none)
    return turning_front(graph, turn_rule(problem.world.site()), alone, run);
  if (alone) return shortest_alone(graph, run);
  const bool chances = problem.front || problem.prefer == Preference::probability;
  return chances && graph.unreliable() ? chance_front(graph, run) : correction_front(graph, run);
}

std::string why_not(const Problem& problem, const CorrectionGraph& graph, const FrontResult& found, RunContext& run) {
  if (found.bound_m < kInfinity)
    return fmt::format("the shortest route within the error limits is {:.1f} m long, beyond the range of {:g} m",
                       found.bound_m, *problem.vehicle.range_m);
  if (graph.limits().turn_model != TurnModel::none && shortest_route(graph, {}, run).route)
    return fmt::format("straight legs lead to the goal within the error limits, but none that turn on {:g} m",
                       graph.limits().turn_radius_m);
  return describe_gap(graph, run);
}

/// Takes what was found into the plan; false if nothing was.
bool settle(const Problem& problem, const FrontResult& found, Plan& plan) {
  const Site& site = problem.world.site();
  const double weight = problem.objective.length;
  plan.lower_bound = weight * found.bound_m;
  if (!found.routes.empty()) {
    std::vector<FrontPoint> front;
    for (const CorrectionRoute& route : found.routes) front.push_back(front_point(site, route));
    const std::size_t choice = preferred(front, problem.prefer);
    plan.outcome = found.proven ? Outcome::optimal : Outcome::feasible;
    plan.route = route_over(site, found.routes[choice].points);
    plan.cost = weight * front[choice].length_m;
    if (problem.prefer == Preference::length && found.proven) plan.lower_bound = plan.cost;
    if (problem.front) plan.front = std::move(front);
  } else if (found.best) {
    plan.outcome = Outcome::feasible;
    plan.route = route_over(site, found.best->points);
    plan.cost = weight * found.best->length_m;
  }
  return !plan.route.empty();
}

/// Exact: A* on labels for the shortest route, layers of labels for the front; branch and bound where legs turn.
struct LabelSettingPlanner {
  static Plan plan(const Problem& problem, RunContext& run) {
    Plan plan{.seed = run.seed(), .why = "stopped before any route reached the goal"};
    if (run.start_iteration(1)) {
      const CorrectionGraph graph(problem.world);
      const FrontResult found = within_range(problem, search(problem, graph, run));
      plan.counters["labels"] = found.labels;
      if (settle(problem, found, plan)) plan.why.clear();
      if (plan.route.empty() && !found.stopped) {
        plan.outcome = Outcome::infeasible_proven;
        plan.lower_bound = 0;
        plan.why = why_not(problem, graph, found, run);
      }
    }
    plan.stop = run.stop();
    plan.reproducible = plan.stop != Stop::deadline && plan.stop != Stop::cancelled;
    plan.counters["iterations"] = run.iterations();
    return plan;
  }
};

}  // namespace

PlannerEntry label_setting_entry() {
  return {.name = "label-setting",
          .help =
              "Exact routes over correction points: the shortest, or the whole front of length, corrections and, "
              "where corrections may fail, probability of success (set navigation.success to 1 for a front without "
              "it). Asked for the shortest route, or to turn, it takes all corrections to work, and tells the "
              "probability. Turns are exact for arc_tangent; free_heading is good, with the bound of straight legs.",
          .can = {.exact = true, .deterministic = true, .terrain = true, .space = "correction points"},
          .presets = {{.name = "default", .help = "It has no parameters."}},
          .parameters = ParamTable(std::vector<Parameter>{}),
          .refuses = correction_refusal,
          .make = [](const ParamValues&) { return Planner(LabelSettingPlanner{}); }};
}

}  // namespace alate
