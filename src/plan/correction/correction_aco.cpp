// Ants on correction points.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp.
#include <algorithm>

#include "aco/colony.hpp"
#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/heuristic/goal_directed.hpp"
#include "aco/one_of.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/roulette.hpp"
#include "plan/correction/correction_aco_parameters.hpp"
#include "plan/correction/correction_heuristic.hpp"
#include "plan/correction/correction_planners.hpp"
#include "search/string_windows.hpp"
#include "space/correction_ants.hpp"

namespace alate {

namespace {

/// Local search on the points of the best ant of an iteration.
struct WindowSearch {
  const StringWindows* windows = nullptr;  ///< Null: none.

  bool operator()(const CorrectionAnts& space, Ant& ant, double /*best*/, RunContext& run) const {
    if (windows == nullptr) return false;
    PointString points = space.points(ant.actions);
    if (!windows->improve(points, run)) return false;
    const auto actions = space.actions(points);
    const auto flight = actions ? space.fly(*actions) : std::nullopt;
    if (!flight || !(flight->cost < ant.cost)) return false;
    ant.actions = *actions;
    ant.cost = flight->cost;
    ant.costs = flight->costs;
    return true;
  }
};

using AnyDeposit = OneOf<AntSystem, MaxMin>;
using PointTrail = Trail<HashCells>;
using Policies = ColonyPolicies<GoalDirected, Roulette, PointTrail, AnyDeposit, WindowSearch>;

class CorrectionAco {
 public:
  explicit CorrectionAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_corrections(problem, run, values_.number("corridor"),
                               [&](const CorrectionTask& task) { return fly_colony(task, run); });
  }

 private:
  std::size_t count(std::string_view name) const { return static_cast<std::size_t>(values_.integer(name)); }

  CorrectionFound fly_colony(const CorrectionTask& task, RunContext& run) const {
    const RelaxedToGo to_go(task.graph, RelaxedToGo::Extent::everywhere, run);
    if (to_go.stopped()) return {};
    const Successors successors(task.graph, to_go, count("candidates"), run);
    const StringWindows windows(task.graph, successors, task.price,
                                {.most_old = count("window_old"), .most_new = count("window_new")});
    const CorrectionAnts space(task.graph, to_go, successors, task.price, count("step_limit"));
    Colony<CorrectionAnts, Policies> colony(space, policies(windows), options());
    const Ant& best = colony.run(run);
    return {.found = best.arrived(),
            .points = space.points(best.actions),
            .candidates = colony.moves() * space.actions(),
            .expansions = colony.moves(),
            .history = colony.history()};
  }

  ColonyOptions options() const {
    return {.ants = count("ants"),
            .iterations = static_cast<std::uint64_t>(values_.integer("iterations")),
            .alpha = static_cast<int>(values_.integer("alpha")),
            .follow = values_.number("follow"),
            .give_up = values_.number("give_up"),
            .step_backs = count("step_backs")};
  }

  Policies policies(const StringWindows& windows) const {
    constexpr double kPlace = 1;  // points nearer to each other than this may share a trail
    const bool max_min = values_.text("deposit") == "max-min";
    const double evaporation = values_.number("evaporation");
    const bool polish = values_.text("local_search") == "windows";
    return {.heuristic = GoalDirected(values_.number("temperature"), values_.number("spread"), count("ants")),
            .transition = Roulette{},
            .trail = PointTrail(HashCells(kPlace), {.evaporation = evaporation, .unknown_decays = max_min}),
            .deposit = deposit(max_min, evaporation),
            .local_search = WindowSearch{polish ? &windows : nullptr}};
  }

  AnyDeposit deposit(bool max_min, double evaporation) const {
    const double q = values_.number("q");
    if (!max_min) return {AntSystem{q}};
    return {MaxMin{.q = q,
                   .evaporation = evaporation,
                   .ratio = values_.number("trail_ratio"),
                   .best_every = static_cast<std::uint64_t>(values_.integer("best_every"))}};
  }

  ParamValues values_;
};

}  // namespace

PlannerEntry correction_aco_entry() {
  return {.name = "correction-aco",
          .help = "An ant colony over correction points.",
          .can = {.anytime = true, .terrain = true, .space = "correction points"},
          .presets = correction_aco_presets(),
          .parameters = ParamTable(correction_aco_parameters()),
          .refuses = heuristic_refusal,
          .make = [](const ParamValues& values) { return Planner(CorrectionAco(values)); }};
}

}  // namespace alate
