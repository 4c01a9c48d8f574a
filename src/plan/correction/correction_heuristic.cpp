#include "plan/correction/correction_heuristic.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "plan/correction/correction_plan.hpp"
#include "space/candidates.hpp"
#include "space/relaxed_to_go.hpp"

namespace alate {

namespace {

std::vector<CorrectionPoint> points_of(const CorrectionGraph& graph, const PointString& string) {
  std::vector<CorrectionPoint> points;
  for (const CorrectionGraph::Node i : string) points.push_back(graph.point(i));
  return points;
}

/// A correction counts as much as the whole direct way where fewer are preferred: length then decides between routes
/// with as many.
RoutePrice price_of(const Problem& problem, const CorrectionGraph& graph) {
  if (problem.prefer != Preference::corrections) return {};
  return {.per_m = 1, .per_correction = graph.to_goal(graph.start())};
}

std::string nothing_found(Stop stop) {
  if (stop == Stop::deadline || stop == Stop::cancelled) return "stopped before any route was found";
  return "no string of correction points that keeps all limits was found; a longer search may find one";
}

class Wrapping {
 public:
  Wrapping(const Problem& problem, RunContext& run) : problem_(problem), run_(run) { plan_.seed = run.seed(); }

  Plan plan(double corridor, const CorrectionSearch& search) {
    const CorrectionGraph whole(problem_.world);
    const double shortest = RelaxedToGo(whole, RelaxedToGo::Extent::until_start, run_)(whole.start());
    bound_m_ = whole.length(whole.start(), whole.goal());
    if (run_.keep_going()) {
      bound_m_ = std::max(bound_m_, shortest);
      if (shortest == kInfinity) return without_way();
      search_in(corridor > 0 ? whole.within(corridor * shortest) : whole, search);
    }
    return finish();
  }

 private:
  static constexpr double kHair = 1e-12;  ///< A sum of legs in another order.

  void search_in(const CorrectionGraph& graph, const CorrectionSearch& search) {
    const double range_m = problem_.vehicle.range_m.value_or(kInfinity);
    CorrectionFound found = search({.graph = graph, .price = price_of(problem_, graph)});
    bound_m_ = std::max(bound_m_, found.bound_m);
    plan_.history = std::move(found.history);
    plan_.counters = {{"candidates", found.candidates}, {"expansions", found.expansions}};
    if (found.exhausted) {
      plan_.outcome = Outcome::infeasible_proven;
      plan_.why = "every string of correction points breaks a limit of the navigation errors or meets an obstacle";
    }
    if (!found.found) return;
    const double length_m = fly(graph, found.points).length_m;
    if (length_m > range_m) {
      plan_.why = fmt::format("the best route found is {:.0f} m long, more than the vehicle's range of {:.0f} m",
                              length_m, range_m);
      return;
    }
    plan_.outcome = length_m * (1 - kHair) <= bound_m_ ? Outcome::optimal : Outcome::feasible;
    plan_.route = route_over(problem_.world.site(), points_of(graph, found.points));
    plan_.cost = problem_.objective.length * length_m;
  }

  Plan without_way() {
    plan_.outcome = Outcome::infeasible_proven;
    plan_.why =
        "even if every correction reset both errors, no string of points leads from the start to the goal: legs are "
        "too "
        "long for the limits";
    return finish();
  }

  Plan finish() {
    if (bound_m_ < kInfinity) plan_.lower_bound = problem_.objective.length * bound_m_ * (1 - kHair);
    plan_.stop = run_.stop();
    plan_.reproducible = plan_.stop != Stop::deadline && plan_.stop != Stop::cancelled;
    plan_.counters["iterations"] = run_.iterations();
    if (plan_.route.empty() && plan_.why.empty()) plan_.why = nothing_found(plan_.stop);
    return std::move(plan_);
  }

  const Problem& problem_;
  RunContext& run_;
  Plan plan_;
  double bound_m_ = 0;
};

}  // namespace

std::string heuristic_refusal(const Problem& problem) {
  if (std::string why = correction_refusal(problem); !why.empty()) return why;
  if (problem.world.site().navigation->turn_model != TurnModel::none)
    return "flies straight legs only; set navigation.turn_model to none";
  if (problem.prefer == Preference::probability)
    return "plans as if every correction worked, and cannot prefer the probability of success";
  return "";
}

Plan plan_on_corrections(const Problem& problem, RunContext& run, double corridor, const CorrectionSearch& search) {
  return Wrapping(problem, run).plan(corridor, search);
}

}  // namespace alate
