// First use of the library: load a scenario, plan a route, check it, write the files.
//
//   first_route examples/jacksboro/scenario.yaml out/first_route
#include <alate/alate.hpp>
#include <exception>
#include <iostream>

namespace {

int fly(const char* scenario_file, const char* folder) {
  // 1. Load. The scenario says what is asked; the site adds the terrain, in one frame of metres.
  //    Bad input throws alate::InputError, which holds every fault and not only the first.
  const alate::Scenario scenario = alate::load_scenario(scenario_file);
  const alate::World world(alate::load_site(scenario));
  const alate::Site& site = world.site();

  // 2. Choose a planner. An empty request means: the scenario's choice, or else the best fit.
  const alate::Problem problem(world);
  const alate::ChosenPlanner chosen = alate::choose_planner(alate::builtin_planners(), problem, {});

  // 3. Plan. The run context holds all limits; no number of threads changes the result.
  alate::Executor executor(2);
  alate::RunContext run(executor, {.seed = 1});
  alate::Plan plan = chosen.planner.plan(problem, run);

  // 4. Check. The verdict is computed from the scenario anew and trusts no planner.
  alate::Result result{.site = site, .planner = chosen, .plan = std::move(plan), .wall_s = run.elapsed_s()};
  result.metrics = alate::measure(site, result.plan.route);
  result.verdict = alate::check(site, result.plan.route);
  std::cout << alate::summary(result) << '\n';

  // 5. Write the report, the mission files and the result.
  alate::write_results(folder, result);
  for (const std::string& name : result.files) std::cout << folder << '/' << name << '\n';
  return !result.plan.route.empty() && result.verdict.ok() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: first_route SCENARIO FOLDER\n";
    return 2;
  }
  try {
    return fly(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
