// Flies a planner of one's own and sets it beside others: docs/write-your-own-planner.md, steps 4 to 6.
//
//   own_policy examples/yin2021/30x30.yaml
#include <fmt/core.h>

#include <exception>
#include <iostream>

#include "alate/alate.hpp"
#include "elitist_aco.hpp"
#include "study/experiment.hpp"

namespace {

using namespace alate;

// [register]
Registry planners() {
  Registry registry = builtin_planners();
  registry.add(elitist_aco_entry());
  return registry;
}
// [/register]

// [run]
bool fly(const Registry& registry, const std::string& scenario) {
  const World world(load_site(load_scenario(scenario)));
  const Problem problem(world);
  const ChosenPlanner chosen =
      choose_planner(registry, problem, {.name = "elitist-aco", .preset = "elitist", .settings = {}});
  Executor executor(2);
  RunContext run(executor, {.seed = 1});
  const Plan plan = chosen.planner.plan(problem, run);
  const Verdict verdict = check(world.site(), plan.route);  // trusts no planner
  fmt::print("{} {}: {:.2f} m, {}\n", chosen.name, chosen.preset, measure(world.site(), plan.route).length_m,
             to_string(verdict.status));
  return !plan.route.empty() && verdict.ok();
}
// [/run]

// [experiment]
Experiment compare(const Registry& registry) {
  std::vector<StudyCase> maps;
  for (int seed = 1; seed <= 5; ++seed) {
    const std::string text = fmt::format(
        "grid: {{random: {{size: [30, 30], obstacles: 0.1, seed: {}}}}}\n"
        "start: {{cell: [0, 29]}}\ngoal: {{cell: [29, 0]}}\n",
        seed);
    maps.push_back({fmt::format("map {}", seed), World(load_site(parse_scenario(text, "inline")))});
  }
  std::vector<StudyMethod> methods;
  for (const auto& [planner, preset] : {std::pair{"elitist-aco", "elitist"},
                                        {"elitist-aco", "plain"},
                                        {"grid-aco", "as"},
                                        {"grid-aco", "rank"},
                                        {"grid-aco", "improved"}})
    methods.push_back({.name = fmt::format("{} {}", planner, preset), .help = {}, .request = {planner, preset, {}}});
  Experiment experiment = plan_experiment(std::move(maps), std::move(methods), /*seeds=*/5, registry);
  Executor executor(2);
  run_experiments({&experiment}, executor, {});
  return experiment;
}
// [/experiment]

// [table]
void print(const Experiment& experiment) {
  fmt::print("\n{:<20}", "mean length, m");
  for (const StudyCase& map : experiment.cases) fmt::print("{:>8}", map.name);
  fmt::print("{:>8}\n", "passed");
  for (std::size_t method = 0; method < experiment.methods.size(); ++method) {
    fmt::print("{:<20}", experiment.methods[method].name);
    std::size_t passed = 0;
    for (std::size_t map = 0; map < experiment.cases.size(); ++map) {
      const Cell cell = experiment.cell(experiment.at(map, method));
      fmt::print("{:>8}", cell.mean ? fmt::format("{:.2f}", *cell.mean) : "-");
      passed += cell.found;
    }
    fmt::print("{:>8}\n", passed);
  }
}
// [/table]

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: own_policy SCENARIO\n";
    return 2;
  }
  try {
    const Registry registry = planners();
    const bool flown = fly(registry, argv[1]);
    print(compare(registry));
    return flown ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
