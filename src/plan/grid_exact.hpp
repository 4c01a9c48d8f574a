// What planners that search height grids exactly share: from a problem to a search, and from its way to a Plan.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "alate/plan/registry.hpp"
#include "plan/grid_plan.hpp"
#include "plan/map_searches.hpp"
#include "space/objective.hpp"

namespace alate {

/// Straight legs through some places, the first of which is the start.
inline Route route_through(const Problem& problem, const std::vector<Vec3>& places) {
  Route route;
  route.states.reserve(places.size());
  for (const Vec3& place : places) route.states.push_back({.position = place, .leg = LegKind::straight});
  route.states.front() = {.position = problem.mission.start, .leg = LegKind::start};
  return route;
}

/// `Legs` says what legs mean: least_length(problem), no route is shorter, before anything was searched, metres;
/// places(grid, cells, way), those of the route; and proven_cost(problem, way, cost), no route costs less, once a
/// search that ran to its end has found a way and its route costs so much.
template <class Search, class Legs>
class GridExact {
 public:
  Plan plan(const Problem& problem, RunContext& run) const {
    const HeightGrid& grid = *problem.world.site().grid;
    const auto [start, goal] = grid_ends(problem);
    auto loan = searches_->borrow(problem.world);
    const auto way =
        loan->search.find(BitGrid::place(start.column, start.row), BitGrid::place(goal.column, goal.row), run);

    Plan plan{.stop = run.stop(), .seed = run.seed()};
    plan.counters = {{"expansions", way.expansions}, {"iterations", run.iterations()}};
    plan.reproducible = way.finished;
    plan.lower_bound = problem.objective.length * Legs::least_length(problem);
    if (way.found) {
      plan.outcome = way.finished ? Outcome::optimal : Outcome::feasible;
      plan.route = route_through(problem, Legs::places(grid, loan->cells, way));
      plan.cost = Objective(problem.world).route_cost(plan.route);
      if (way.finished) plan.lower_bound = Legs::proven_cost(problem, way, plan.cost);
    } else if (way.finished) {
      plan.outcome = Outcome::infeasible_proven;
      plan.why = no_way(problem);
    } else {
      plan.why = "stopped before any route was found";
    }
    searches_->give_back(std::move(loan));
    return plan;
  }

 private:
  std::shared_ptr<MapSearches<Search>> searches_ = std::make_shared<MapSearches<Search>>();
};

/// How a planner is listed.
struct GridExactTexts {
  std::string name;
  std::string help;
  Preset preset;
  std::string fits;
};

template <class Search, class Legs>
PlannerEntry grid_exact_entry(GridExactTexts texts) {
  return {.name = std::move(texts.name),
          .help = std::move(texts.help),
          .can = {.exact = true, .deterministic = true, .space = "height grid"},
          .presets = {std::move(texts.preset)},
          .parameters = ParamTable(std::vector<Parameter>{}),
          .refuses = grid_refusal,
          .make = [](const ParamValues&) { return Planner(GridExact<Search, Legs>()); },
          .fits = std::move(texts.fits)};
}

}  // namespace alate
