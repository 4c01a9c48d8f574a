#include "plan/attitude/attitude_plan.hpp"

#include <fmt/core.h>

#include <optional>

#include "plan/place_name.hpp"

namespace alate {

namespace {

Route route_of(const AttitudeSpace& space, const std::vector<std::size_t>& actions) {
  AttitudeState state = space.start();
  Route route;
  route.states.push_back({.position = state.position, .leg = LegKind::start});
  for (const std::size_t k : actions) {
    state = space.next(state, k);
    route.states.push_back(
        {.position = state.position, .leg = LegKind::straight, .action = space.rotations().action(k)});
  }
  return route;
}

/// Is there anything between start and goal that the straight line does not know of? The node model has no such field.
bool needs_guidance(const Problem& problem) {
  const Site& site = problem.world.site();
  return problem.objective.model == CostModel::physical && (site.has_ground() || !site.threats.empty());
}

/// Does any candidate leave the start?
bool can_leave(const AttitudeSpace& space) {
  Candidates candidates;
  const AttitudeState start = space.start();
  space.expand(start, candidates);
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (candidates.cost[k] < kInfinity && space.is_free(start, space.next(start, k))) return true;
  return false;
}

std::string nothing_found(const Problem& problem, const AttitudeSpace& space, Stop stop) {
  const Vec2 start = problem.mission.start.head<2>();
  if (!can_leave(space))
    return fmt::format("no move from the start ({}) keeps the band, the cores and the limits of the aircraft",
                       place_name(problem.world.site(), start));
  if (stop == Stop::deadline || stop == Stop::cancelled) return "stopped before any route reached the goal";
  return fmt::format("no string of up to {} moves reached the goal's tolerance of {} m; a wider search may find one",
                     space.step_limit(), problem.mission.tolerance_m);
}

std::string no_way(const Problem& problem, const CostToGo& guidance) {
  const Vec2 start = problem.mission.start.head<2>();
  const Vec2 reached = guidance.nearest_reached(start);
  return fmt::format(
      "on coarse cells no way within band, cores and climb limits leads from the start to the goal: seen from the goal "
      "it ends at {}, {:.0f} m from the start",
      place_name(problem.world.site(), reached), (reached - start).norm());
}

}  // namespace

std::string attitude_refusal(const Problem& problem) {
  if (problem.world.site().navigation)
    return "knows nothing of navigation errors and correction points; take label-setting, or leave out navigation";
  if (problem.world.site().voxels) return "flies through the air, not among voxels; take jps, or leave out grid";
  if (problem.world.site().grid)
    return "flies through the air, not from cell to cell; take grid-aco, or leave out grid";
  const Vehicle& vehicle = problem.vehicle;
  std::string missing;
  const auto need = [&](bool given, const char* key) {
    if (!given) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", key);
  };
  need(vehicle.step_m.has_value(), "vehicle.step_m");
  need(!vehicle.roll_rad.empty(), "vehicle.roll_deg");
  need(!vehicle.pitch_rad.empty(), "vehicle.pitch_deg");
  need(!vehicle.yaw_rad.empty(), "vehicle.yaw_deg");
  if (missing.empty()) return "";
  return fmt::format("flies in steps of constant length and attitude, which the vehicle does not have; add {}",
                     missing);
}

Parameter step_limit_parameter() {
  return {.name = "step_limit",
          .default_value = std::int64_t{0},
          .min = 0,
          .max = 1e5,
          .help = "Longest route in steps; 0: 3.4 times the direct distance (40 in the paper's case).",
          .source = "alate: Konatowski, Pawlowski 2019 leave it open"};
}

Plan plan_on_attitudes(const Problem& problem, RunContext& run, const AttitudeOptions& options,
                       const std::function<SearchResult(const AttitudeSpace&)>& search) {
  Plan plan{.seed = run.seed()};
  std::optional<CostToGo> guidance;
  if (needs_guidance(problem)) guidance.emplace(problem.world, run);
  const AttitudeSpace space(problem.world, guidance ? &*guidance : nullptr, options);
  plan.lower_bound = space.problem_bound();

  SearchResult found;
  const bool sees_way = !guidance || !run.keep_going() || (*guidance)(problem.mission.start) < kInfinity;
  if (sees_way) found = search(space);
  if (found.found) {
    plan.outcome = Outcome::feasible;
    plan.route = route_of(space, found.actions);
    plan.cost = Objective(problem.world).route_cost(plan.route);  // as reported, whatever was minimised
  }
  plan.stop = run.stop();
  plan.reproducible = plan.stop != Stop::deadline && plan.stop != Stop::cancelled;
  plan.counters = {
      {"candidates", found.candidates}, {"expansions", found.expansions}, {"iterations", run.iterations()}};
  if (!found.found) plan.why = sees_way ? nothing_found(problem, space, plan.stop) : no_way(problem, *guidance);
  return plan;
}

}  // namespace alate
