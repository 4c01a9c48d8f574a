// The flagship: a fixed wing over real ground, by true Dubins pieces and intervals of altitude.
#include "plan/flight/flight_bound.hpp"
#include "plan/flight/flight_plan.hpp"
#include "plan/flight/flight_planners.hpp"
#include "plan/flight/interval_run.hpp"

namespace alate {

namespace {

struct IntervalPlanner {
  BoundEffort effort = BoundEffort::quick;

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_flight(problem, run, kNoFlight, [&](Plan& plan) { search(problem, run, plan); });
  }

 private:
  void search(const Problem& problem, RunContext& run, Plan& plan) const {
    const FlightAir air(problem.world);
    ClimbField to_go(air.world, air.band.slopes(), run, problem.mission.start);
    IntervalAStar astar(air.cost, to_go);
    IntervalRun(air, problem.mission, run).improve(to_go, astar, plan, [&](Plan& so_far) {
      note_bound(problem, effort, run, so_far);
    });
  }
};

std::string refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.grid || site.voxels) return "flies through the air, not from cell to cell; take jps, or leave out grid";
  if (site.navigation) return "knows nothing of navigation errors; take label-setting, or leave out navigation";
  if (!problem.vehicle.turn_radius_m || *problem.vehicle.turn_radius_m <= 0)
    return "flies circles; add vehicle.turn_radius_m";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  return "";
}

}  // namespace

PlannerEntry interval_astar_entry() {
  return {
      .name = "interval-astar",
      .help = "Dubins pieces over real ground, altitudes as intervals; then bettered until the time is up.",
      .can = {.anytime = true, .deterministic = false, .terrain = true, .threats = true, .space = "Dubins flight"},
      .presets = {{.name = "default", .help = "As the table says."}},
      .parameters = ParamTable(
          {{.name = "bound",
            .default_value = std::string("quick"),
            .choices = {"quick", "tight"},
            .help = "Work on the lower bound: about 10 ms, or some tenths of a second of the time there is (--bound).",
            .source = "alate"}}),
      .refuses = refusal,
      .make =
          [](const ParamValues& values) {
            return Planner(IntervalPlanner{values.text("bound") == "tight" ? BoundEffort::tight : BoundEffort::quick});
          },
      .fits = "an aircraft with a turn radius flies cheapest along arcs and straight legs that follow the ground"};
}

}  // namespace alate
