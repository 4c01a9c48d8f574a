// What planners that search maps exactly share: from a problem to a search, and from its way to a Plan.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "alate/plan/registry.hpp"
#include "plan/grid/grid_plan.hpp"
#include "plan/grid/map_searches.hpp"
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

/// What legs on height grids have in common.
struct GridLegs {
  using Cells = BitGrid;
  static constexpr bool kProven = true;
  static std::pair<GridPlace, GridPlace> ends(const Problem& problem) {
    const auto [start, goal] = grid_ends(problem);
    return {BitGrid::place(start.column, start.row), BitGrid::place(goal.column, goal.row)};
  }
  static std::string no_way(const Problem& problem) { return alate::no_way(problem); }
};

/// `Legs` says what legs mean: Cells, the map as it is searched; ends(problem), its places; least_length(problem), no
/// route is shorter, before anything was searched, metres; places(problem, cells, way), those of the route;
/// proven_cost(problem, way, cost), no route costs less, once a search that ran to its end has found a way and its
/// route costs so much; no_way(problem), why there is none; and kProven, whether a search that ran to its end has
/// proven its way the shortest.
template <class Search, class Legs>
class CellExact {
 public:
  Plan plan(const Problem& problem, RunContext& run) const {
    const auto [start, goal] = Legs::ends(problem);
    auto loan = searches_->borrow(problem.world);
    const auto way = loan->search.find(start, goal, run);

    Plan plan{.stop = run.stop(), .seed = run.seed()};
    plan.counters = {{"expansions", way.expansions}, {"iterations", run.iterations()}};
    plan.reproducible = way.finished;
    plan.lower_bound = problem.objective.length * Legs::least_length(problem);
    if (way.found) {
      plan.outcome = way.finished && Legs::kProven ? Outcome::optimal : Outcome::feasible;
      plan.route = route_through(problem, Legs::places(problem, loan->cells, way));
      plan.cost = Objective(problem.world).route_cost(plan.route);
      if (plan.outcome == Outcome::optimal) plan.lower_bound = Legs::proven_cost(problem, way, plan.cost);
    } else if (way.finished) {
      plan.outcome = Outcome::infeasible_proven;
      plan.why = Legs::no_way(problem);
    } else {
      plan.why = "stopped before any route was found";
    }
    searches_->give_back(std::move(loan));
    return plan;
  }

 private:
  using Searches = MapSearches<Search, typename Legs::Cells>;
  std::shared_ptr<Searches> searches_ = std::make_shared<Searches>();
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
          .make = [](const ParamValues&) { return Planner(CellExact<Search, Legs>()); },
          .fits = std::move(texts.fits)};
}

}  // namespace alate
