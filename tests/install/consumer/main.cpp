// Prints the version, and what came of planning a small scenario.
#include <alate/alate.hpp>
#include <iostream>

int main() {
  const char* text = R"(
    frame: {local: true}
    start: {position_m: [0, 0, 100], heading_deg: 90}
    goal: {position_m: [3000, 500, 100], tolerance_m: 200}
    vehicle: {step_m: 200, roll_deg: [0], pitch_deg: [-5, 0, 5], yaw_deg: [-10, 0, 10]}
    threats: [{name: radar, center_m: [1500, 250, 100], radius_m: 400, core_m: 100}]
  )";
  const alate::World world(alate::load_site(alate::parse_scenario(text, "inline")));
  const alate::Problem problem(world);
  const alate::ChosenPlanner chosen = alate::choose_planner(alate::builtin_planners(), problem, {});
  alate::Executor executor(1);
  alate::RunContext run(executor, {});
  const alate::Plan plan = chosen.planner.plan(problem, run);
  const alate::Verdict verdict = alate::check(world.site(), plan.route);
  std::cout << "alate " << alate::version() << ": " << to_string(plan.outcome) << ", " << to_string(verdict.status)
            << '\n';
  return verdict.ok() ? 0 : 1;
}
