#include "plan/terrain/terrain_plan.hpp"

#include <fmt/core.h>

#include <optional>

#include "plan/iteration_history.hpp"
#include "space/lower_bound.hpp"

namespace alate {

namespace {

Route route_over(const std::vector<Vec3>& places) {
  Route route;
  for (const Vec3& place : places)
    route.states.push_back({.position = place, .leg = route.empty() ? LegKind::start : LegKind::straight});
  return route;
}

bool was_stopped(Stop stop) { return stop == Stop::deadline || stop == Stop::cancelled; }

/// Where the lattice ends; its moves say nothing of the air between its nodes.
std::string no_way(const TerrainLattice& lattice) {
  const LatticeFrame& frame = lattice.frame();
  const int last = lattice.moves().last_plane();
  const std::string advice = "; shorter steps may find a way, as the lattice holds but a part of the air";
  if (last + 1 < frame.planes())
    return fmt::format(
        "moves of the lattice that keep band, cores and limits lead no farther than plane {} of {}, at {}{}", last,
        frame.planes(), frame.plane_name(last), advice);
  return fmt::format("moves of the lattice lead to its last plane, at {}, but from no node there on to the goal{}",
                     frame.plane_name(last), advice);
}

void count(const TerrainLattice& lattice, const LatticeTally& tally, Plan& plan) {
  const bool filters = lattice.moves().rules().filters;
  const LatticeFaults& faults = filters ? lattice.moves().barred() : tally.faults;
  const std::string kind = filters ? "barred_" : "broken_";
  plan.counters.insert({{kind + "leg", faults.leg},
                        {kind + "height", faults.height},
                        {kind + "pitch", faults.pitch},
                        {kind + "turn", faults.turn},
                        {"broken_length", tally.faults.length},
                        {"collisions", tally.faults.collision},
                        {"dead_ends", tally.dead_ends}});
}

/// Turning limits, which has_way does not ask, or the length.
std::string no_string() {
  return "moves of the lattice lead to the goal, but no string of them keeps the limits of turns and of the route's "
         "length; other steps may find a way, as the lattice holds but a part of the air";
}

/// False where the search saw that no string of moves is a route.
bool fill(const Problem& problem, const TerrainLattice& lattice, const TerrainSearch& search, Plan& plan) {
  LatticeFound found = search(lattice);
  count(lattice, found.tally, plan);
  plan.counters["candidates"] = found.moves * lattice.frame().moves();
  plan.counters["expansions"] = found.moves;
  plan.counters["last_change"] = last_change(found.history);
  plan.history = std::move(found.history);
  if (found.places.empty()) return !found.is_exhausted;
  plan.outcome = Outcome::feasible;
  plan.route = route_over(found.places);
  plan.cost = Objective(problem.world).route_cost(plan.route);
  return true;
}

struct Task {
  const Problem& problem;
  RunContext& run;
  const TerrainSearch& search;
};

/// Says what is wrong; empty once there is a route. Where a narrow window leads nowhere a wide one is tried.
std::string search_lattice(const Task& task, const LatticeOptions& options, Plan& plan) {
  const auto& [problem, run, search] = task;
  LatticeFrame frame(problem.world, options.steps);
  if (!frame.fault().empty()) return frame.fault();
  const TerrainLattice lattice(problem.world, std::move(frame), options, run);
  if (lattice.moves().stopped()) return "stopped before any route was found";
  if (!lattice.moves().has_way() || !fill(problem, lattice, search, plan)) {
    if (options.steps.side_m > 0 || options.steps.side_share >= 1)
      return lattice.moves().has_way() ? no_string() : no_way(lattice);
    LatticeOptions wide = options;
    wide.steps.side_share = 1;
    return search_lattice(task, wide, plan);
  }
  if (!plan.route.empty()) return "";
  if (was_stopped(run.stop())) return "stopped before any route was found";
  return "every try ended in a dead end or broke a limit, though moves lead to the goal; a longer search may find a "
         "route";
}

}  // namespace

std::string terrain_refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.voxels) return "flies through the air, not among voxels; take jps, or leave out grid";
  if (site.grid) return "flies through the air, not from cell to cell; take grid-aco, or leave out grid";
  if (site.navigation)
    return "knows nothing of navigation errors and correction points; take label-setting, or leave out navigation";
  if (!site.has_ground()) return "lays its lattice over ground; add terrain";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  return "";
}

Plan plan_over_terrain(const Problem& problem, RunContext& run, const LatticeOptions& options,
                       const TerrainSearch& search) {
  constexpr double kHair = 1e-12;  // a sum of legs in another order
  const Mission& mission = problem.mission;
  Plan plan{.lower_bound = physical_bound(problem.world.site(), mission.start) * (1 - kHair), .seed = run.seed()};
  if ((mission.goal - mission.start).norm() <= mission.tolerance_m) {
    plan.outcome = Outcome::feasible;
    plan.route = route_over({mission.start});
  } else {
    plan.why = search_lattice({problem, run, search}, options, plan);
  }
  plan.counters["iterations"] = run.iterations();
  plan.stop = run.stop();
  plan.reproducible = !was_stopped(plan.stop);
  return plan;
}

}  // namespace alate
