#include "plan/grid/grid_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "plan/iteration_history.hpp"
#include "space/objective.hpp"

namespace alate {

namespace {

/// The free cell whose middle `place` is.
std::optional<GridCellPlace> cell_of(const HeightGrid& grid, const Vec3& place) {
  constexpr double kHair = 1e-9;
  const auto found = grid.cell_at(place.head<2>());
  if (!found) return std::nullopt;
  const GridCellPlace cell{.column = (*found)[0], .row = (*found)[1]};
  if (grid.blocked_at(cell.column, cell.row)) return std::nullopt;
  if ((grid.center(cell.column, cell.row) - place).norm() > kHair * grid.cell_m) return std::nullopt;
  return cell;
}

Route route_of(const Problem& problem, const GridSpace& space, const std::vector<std::uint32_t>& directions) {
  Route route;
  route.states.reserve(directions.size() + 1);
  route.states.push_back({.position = problem.mission.start, .leg = LegKind::start});
  GridSpace::Cell cell = space.start();
  for (const std::uint32_t d : directions) {
    cell = space.neighbour(cell, d);
    const Vec3 center = problem.world.site().grid->center(space.column(cell), space.row(cell));
    route.states.push_back({.position = center, .leg = LegKind::straight});
  }
  return route;
}

std::string dead_end(const GridSpace& space, const std::vector<std::uint8_t>& reached) {
  GridSpace::Cell nearest = space.start();
  for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell)
    if (reached[cell] != 0 && space.to_goal(cell) < space.to_goal(nearest)) nearest = cell;
  return fmt::format(
      "blocked cells part the start from the goal: of the cells that moves from the start reach, [{}, {}] is the "
      "nearest to the goal, {:.1f} cells from it",
      space.column(nearest), space.row(nearest), space.to_goal(nearest));
}

GridSpace::Ends ends_of(const Problem& problem) {
  const auto [start, goal] = grid_ends(problem);
  return {.start_column = start.column, .start_row = start.row, .goal_column = goal.column, .goal_row = goal.row};
}

std::string nothing_found(Stop stop) {
  if (stop == Stop::deadline || stop == Stop::cancelled) return "stopped before any route was found";
  return "every ant walked into a dead end, though there is a way; a longer search may find it";
}

/// From cell sides to metres.
std::vector<IterationStats> in_metres(std::vector<IterationStats> history, double cell_m) {
  for (IterationStats& stats : history)
    for (std::optional<double>* length : {&stats.best_so_far, &stats.best, &stats.mean, &stats.worst})
      if (*length) **length *= cell_m;
  return history;
}

}  // namespace

std::string grid_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.voxels) return "steps from cell to cell in one plane, not among voxels; take jps";
  if (!site.grid) return "steps from cell to cell of a grid; add grid";
  if (!cell_of(*site.grid, problem.mission.start) || !cell_of(*site.grid, problem.mission.goal))
    return "starts and ends in the middle of free cells; give start.cell and goal.cell";
  return step_refusal(problem);
}

std::string step_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.navigation) return "knows nothing of navigation errors; leave out navigation";
  if (!site.threats.empty()) return "knows nothing of threats; leave them out, or block their cells";
  if (site.vehicle.turn_radius_m)
    return "flies straight legs with corners, which the vehicle's turning radius forbids; leave out "
           "vehicle.turn_radius_m";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  return "";
}

GridEnds grid_ends(const Problem& problem) {
  const HeightGrid& grid = *problem.world.site().grid;
  return {*cell_of(grid, problem.mission.start), *cell_of(grid, problem.mission.goal)};
}

double least_length(const Problem& problem) {
  constexpr double kHair = 1e-12;  // a sum of legs in another order
  const auto [start, goal] = grid_ends(problem);
  const int across = std::abs(start.column - goal.column);
  const int along = std::abs(start.row - goal.row);
  const int both = std::min(across, along);
  return problem.world.site().grid->cell_m * (std::max(across, along) - both + both * std::numbers::sqrt2) *
         (1 - kHair);
}

std::string no_way(const Problem& problem) {
  const GridSpace space(*problem.world.site().grid, ends_of(problem), std::numbers::sqrt2, {});
  return dead_end(space, space.flood(space.start()));
}

Plan plan_on_grid(const Problem& problem, RunContext& run, const GridOptions& options, const GridSearch& search) {
  const HeightGrid& grid = *problem.world.site().grid;
  const GridSpace space(grid, ends_of(problem), options.diagonal, options.score);
  const std::vector<std::uint8_t> reached = space.flood(space.start());
  const bool has_way = reached[space.goal()] != 0;

  GridFound found;
  if (space.start() == space.goal())
    found.found = true;
  else if (has_way)
    found = search(space);
  Plan plan;
  plan.seed = run.seed();
  plan.lower_bound = problem.objective.length * least_length(problem);
  if (found.found) {
    plan.outcome = Outcome::feasible;
    plan.route = route_of(problem, space, found.directions);
    plan.cost = Objective(problem.world).route_cost(plan.route);
  }
  plan.stop = run.stop();
  plan.reproducible = plan.stop != Stop::deadline && plan.stop != Stop::cancelled;
  plan.counters = {{"candidates", found.moves * GridSpace::kDirections},
                   {"expansions", found.moves},
                   {"iterations", run.iterations()},
                   {"last_change", last_change(found.history)}};
  plan.history = in_metres(std::move(found.history), grid.cell_m);
  if (!has_way) plan.outcome = Outcome::infeasible_proven;
  if (!found.found) plan.why = has_way ? nothing_found(plan.stop) : dead_end(space, reached);
  return plan;
}

}  // namespace alate
