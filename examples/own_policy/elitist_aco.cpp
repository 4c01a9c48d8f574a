// A policy becomes a planner: docs/write-your-own-planner.md, steps 2 and 3.
#include "elitist_aco.hpp"

#include <numbers>

#include "aco/colony.hpp"
#include "aco/heuristic/goal_table.hpp"
#include "aco/local_search/none.hpp"
#include "aco/transition/move_table.hpp"
#include "aco/walk/grid_walk.hpp"
#include "elitist.hpp"
#include "plan/colony_parameters.hpp"
#include "plan/grid/grid_plan.hpp"

namespace {

using namespace alate;

// [planner]
class ElitistAco {
 public:
  explicit ElitistAco(ParamValues values) : values_(std::move(values)) {}

  /// What a planner is: any type with this one function.
  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_grid(problem, run, {.diagonal = std::numbers::sqrt2, .score = {}},
                        [&](const GridSpace& space) { return search(space, run); });
  }

 private:
  GridFound search(const GridSpace& space, RunContext& run) const;

  ParamValues values_;
};
// [/planner]

// [colony]
GridFound ElitistAco::search(const GridSpace& space, RunContext& run) const {
  using Policies = GridPolicies<MoveTable, Elitist, NoLocalSearch>;
  const TrailRule trails{.evaporation = values_.number("evaporation"), .initial = 0.1, .unknown_decays = true};
  Colony<GridSpace, Policies> colony(
      space,
      Policies{.choice = MoveTable(goal_directed_table(space, 0.4), /*alpha=*/1, /*q0=*/0),
               .trail = Trail<MoveCells>(MoveCells(space.cells()), trails),
               .deposit = Elitist{.q = 1, .elitists = values_.number("elitists")},
               .local_search = NoLocalSearch{}},
      {.ants = static_cast<std::size_t>(values_.integer("ants")),
       .iterations = static_cast<std::uint64_t>(values_.integer("iterations"))});
  const Ant& best = colony.run(run);
  return {.found = best.arrived(), .directions = best.actions, .moves = colony.moves(), .history = colony.history()};
}
// [/colony]

// [parameters]
std::vector<Parameter> parameters() {
  return {ants_parameter(50, "as the textbook colonies of grid-aco"),
          iterations_parameter(100, "as the textbook colonies of grid-aco"),
          evaporation_parameter(0.3, "Dorigo, Maniezzo, Colorni 1996, eq. (1), 1 - rho"),
          {.name = "elitists",
           .unit = "ants",
           .default_value = 8.0,
           .min = 0,
           .max = 1e6,
           .help = "The best route so far gets as much as so many ants would leave on it.",
           .source = "Dorigo, Maniezzo, Colorni 1996, elitist strategy"}};
}
// [/parameters]

}  // namespace

// [entry]
PlannerEntry elitist_aco_entry() {
  return {.name = "elitist-aco",
          .help = "Elitist Ant System on a grid.",
          .can = {.anytime = true, .space = "height grid"},
          .presets = {{.name = "elitist", .help = "Eight elitists.", .values = {}},
                      {.name = "plain", .help = "None: Ant System.", .values = {{"elitists", 0.0}}}},
          .parameters = ParamTable(parameters()),
          .refuses = grid_refusal,
          .make = [](const ParamValues& values) { return Planner(ElitistAco(values)); }};
}
// [/entry]
