// Planners that find the shortest way from cell to cell, and prove it.
#include "plan/grid_plan.hpp"
#include "plan/grid_planners.hpp"
#include "plan/map_searches.hpp"
#include "plan/terrain_planners.hpp"
#include "search/grid/astar.hpp"
#include "search/grid/jps.hpp"
#include "space/objective.hpp"

namespace alate {

namespace {

constexpr const char* kStopped = "stopped before any route was found";

/// One state a corner. The ends are those of the mission to the last bit.
Route route_over(const Problem& problem, const GridWay& way) {
  const HeightGrid& grid = *problem.world.site().grid;
  Route route;
  route.states.reserve(way.corners.size());
  for (const GridPlace corner : way.corners)
    route.states.push_back({.position = grid.center(corner.column - 1, corner.row - 1), .leg = LegKind::straight});
  route.states.front() = {.position = problem.mission.start, .leg = LegKind::start};
  return route;
}

template <class Search>
class GridExact {
 public:
  Plan plan(const Problem& problem, RunContext& run) const {
    const auto [start, goal] = grid_ends(problem);
    auto loan = searches_->borrow(problem.world);
    const GridWay way =
        loan->search.find(BitGrid::place(start.column, start.row), BitGrid::place(goal.column, goal.row), run);
    searches_->give_back(std::move(loan));

    Plan plan{.stop = run.stop(), .seed = run.seed()};
    plan.counters = {{"expansions", way.expansions}, {"iterations", run.iterations()}};
    plan.reproducible = way.finished;
    plan.lower_bound = problem.objective.length * least_length(problem);
    if (way.found) {
      plan.outcome = way.finished ? Outcome::optimal : Outcome::feasible;
      plan.route = route_over(problem, way);
      plan.cost = Objective(problem.world).route_cost(plan.route);
      if (way.finished) plan.lower_bound = plan.cost;
    } else if (way.finished) {
      plan.outcome = Outcome::infeasible_proven;
      plan.why = no_way(problem);
    } else {
      plan.why = kStopped;
    }
    return plan;
  }

 private:
  std::shared_ptr<MapSearches<Search>> searches_ = std::make_shared<MapSearches<Search>>();
};

template <class Search>
PlannerEntry exact_entry(std::string_view name, std::string_view help) {
  return {.name = std::string(name),
          .help = std::string(help),
          .can = {.exact = true, .deterministic = true, .space = "height grid"},
          .presets = {{.name = "default", .help = "It has no parameters."}},
          .parameters = ParamTable(std::vector<Parameter>{}),
          .refuses = grid_refusal,
          .make = [](const ParamValues&) { return Planner(GridExact<Search>()); },
          .fits =
              "on a grid where only length counts, exact search is quick and proves its route the shortest from "
              "cell to cell"};
}

}  // namespace

PlannerEntry jps_entry() {
  PlannerEntry entry = exact_entry<JumpPointSearch>(
      "jps",
      "Jump point search: the shortest way from cell to cell of a grid, proven, and the quickest to find it (Harabor "
      "and Grastien 2011, 2014).");
  entry.refuses = [](const Problem& problem) -> std::string {
    if (is_over_terrain(problem.world.site()))
      return "jumps over cells that all cost the same, and over terrain each leg has a cost of its own; take astar or "
             "theta-star";
    return grid_refusal(problem);
  };
  return entry;
}

PlannerEntry astar_entry() {
  return exact_entry<GridAStar>(
      "astar", "A*: the shortest way from cell to cell of a grid, proven (Hart, Nilsson and Raphael 1968).");
}

}  // namespace alate
