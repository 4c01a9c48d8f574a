// A planner in a program of its own, beside those of the installed library: docs/write-your-own-planner.md, outside.
//
//   own_planner examples/yin2021/30x30.yaml
#include <alate/alate.hpp>
#include <array>
#include <deque>
#include <exception>
#include <iostream>

namespace {

using Cell = std::array<int, 2>;  // column, row

// [planner]
/// Fewest steps across the sides of cells, by breadth-first search.
class FewestSteps {
 public:
  alate::Plan plan(const alate::Problem& problem, alate::RunContext& run) const {
    const alate::HeightGrid& grid = *problem.world.site().grid;
    // From the goal, so that the trail of steps leads there from the start.
    const Cell start = *grid.cell_at(problem.mission.start.head<2>());
    const Cell goal = *grid.cell_at(problem.mission.goal.head<2>());
    std::vector<Cell> next(grid.blocked.size(), kNone);
    std::deque<Cell> front{goal};
    next[grid.index(goal[0], goal[1])] = goal;
    std::uint64_t expansions = 0;
    while (!front.empty() && next[grid.index(start[0], start[1])] == kNone) {
      if (++expansions % 1024 == 0 && !run.keep_going()) break;
      const Cell cell = front.front();
      front.pop_front();
      for (const auto& [right, down] : {Cell{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        const Cell beside{cell[0] + right, cell[1] + down};
        if (!grid.contains(beside[0], beside[1]) || grid.blocked_at(beside[0], beside[1])) continue;
        if (next[grid.index(beside[0], beside[1])] != kNone) continue;
        next[grid.index(beside[0], beside[1])] = cell;
        front.push_back(beside);
      }
    }
    return written(grid, next, start, run);
  }

 private:
  static constexpr Cell kNone{-1, -1};

  static alate::Plan written(const alate::HeightGrid& grid, const std::vector<Cell>& next, Cell cell,
                             const alate::RunContext& run) {
    alate::Plan plan;
    plan.seed = run.seed();
    plan.stop = run.stop();
    plan.reproducible = plan.stop != alate::Stop::deadline && plan.stop != alate::Stop::cancelled;
    if (next[grid.index(cell[0], cell[1])] == kNone) {
      plan.outcome = plan.reproducible ? alate::Outcome::infeasible_proven : alate::Outcome::none_found;
      plan.why =
          plan.reproducible ? "no steps lead from the start to the goal" : "stopped before the start was reached";
      return plan;
    }
    plan.outcome = alate::Outcome::feasible;
    plan.route.states.push_back({.position = grid.center(cell[0], cell[1]), .leg = alate::LegKind::start});
    while (next[grid.index(cell[0], cell[1])] != cell) {
      cell = next[grid.index(cell[0], cell[1])];
      plan.route.states.push_back({.position = grid.center(cell[0], cell[1]), .leg = alate::LegKind::straight});
      plan.cost += grid.cell_m;
    }
    return plan;
  }
};
// [/planner]

// [entry]
std::string refusal(const alate::Problem& problem) {
  return problem.world.site().grid ? "" : "steps from cell to cell of a grid; add grid";
}

alate::PlannerEntry fewest_steps_entry() {
  return {.name = "fewest-steps",
          .help = "Breadth-first search over the sides of cells.",
          .can = {.deterministic = true, .space = "height grid"},
          .presets = {{.name = "default", .help = "There is but one.", .values = {}}},
          .parameters = alate::ParamTable(),
          .refuses = refusal,
          .make = [](const alate::ParamValues& /*values*/) { return alate::Planner(FewestSteps()); }};
}
// [/entry]

// [run]
int compare(const char* scenario) {
  alate::Registry planners = alate::builtin_planners();
  planners.add(fewest_steps_entry());

  const alate::World world(alate::load_site(alate::load_scenario(scenario)));
  const alate::Problem problem(world);
  bool all_pass = true;
  for (const char* name : {"fewest-steps", "grid-aco"}) {
    const alate::ChosenPlanner chosen = alate::choose_planner(planners, problem, {name, "", {}});
    alate::Executor executor(2);
    alate::RunContext run(executor, {.seed = 1});
    const alate::Plan plan = chosen.planner.plan(problem, run);
    const alate::Verdict verdict = alate::check(world.site(), plan.route);
    std::cout << chosen.name << ": " << alate::measure(world.site(), plan.route).length_m << " m, "
              << to_string(verdict.status) << '\n';
    all_pass = all_pass && verdict.ok();
  }
  return all_pass ? 0 : 1;
}
// [/run]

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: own_planner SCENARIO\n";
    return 2;
  }
  try {
    return compare(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
