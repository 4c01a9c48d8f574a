// Ants on the attitude lattice: Konatowski, Pawlowski 2019 as published, and made good.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp.
#include "aco/colony.hpp"
#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/colony_system.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/deposit/none.hpp"
#include "aco/deposit/rank_based.hpp"
#include "aco/heuristic/goal_directed.hpp"
#include "aco/heuristic/power.hpp"
#include "aco/local_search/action_string.hpp"
#include "aco/local_search/none.hpp"
#include "aco/one_of.hpp"
#include "aco/pheromone/grid_cells.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/pseudo_random.hpp"
#include "aco/transition/roulette.hpp"
#include "plan/attitude/attitude_aco_parameters.hpp"
#include "plan/attitude/attitude_plan.hpp"
#include "plan/attitude/attitude_planners.hpp"
#include "search/beam.hpp"
#include "search/greedy.hpp"
#include "space/attitude_ants.hpp"

namespace alate {

namespace {

using AnyHeuristic = OneOf<GoalDirected, PowerHeuristic>;
using AnyTransition = OneOf<Roulette, PseudoRandom>;
using AnyDeposit = OneOf<NoDeposit, AntSystem, RankBased, MaxMin, ColonySystem>;
using AnyLocalSearch = OneOf<NoLocalSearch, ActionString>;

class AttitudeAco {
 public:
  explicit AttitudeAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    std::vector<IterationStats> history;
    const AttitudeOptions options{
        .step_limit = static_cast<std::size_t>(values_.integer("step_limit")),
        .threats_at = values_.text("threats_at") == "legs" ? ThreatsAt::legs : ThreatsAt::nodes};
    Plan plan = plan_on_attitudes(problem, run, options, [&](const AttitudeSpace& lattice) {
      const AttitudeAnts space(problem.world, lattice);
      if (lattice.is_goal(lattice.start())) return SearchResult{.found = true, .cost = 0};
      const double cell_m = trail_cell_m(problem);
      if (std::optional<GridCells> grid = dense_grid(space, cell_m))
        return fly_colony(space, *std::move(grid), run, history);
      return fly_colony(space, HashCells(cell_m), run, history);
    });
    plan.history = std::move(history);
    return plan;
  }

 private:
  bool on_points() const { return values_.text("trail") == "points"; }

  double trail_cell_m(const Problem& problem) const {
    constexpr double kPoint = 1e-4;  // of a metre: what counts as the same point
    return on_points() ? kPoint : values_.number("trail_cell") * *problem.vehicle.step_m;
  }

  std::optional<GridCells> dense_grid(const AttitudeAnts& space, double cell_m) const {
    if (on_points()) return std::nullopt;
    return GridCells::over(space.reach(), static_cast<float>(cell_m));
  }

  template <class Store>
  SearchResult fly_colony(const AttitudeAnts& space, Store store, RunContext& run,
                          std::vector<IterationStats>& history) const {
    using Policies = ColonyPolicies<AnyHeuristic, AnyTransition, Trail<Store>, AnyDeposit, AnyLocalSearch>;
    Colony<AttitudeAnts, Policies> colony(space,
                                          Policies{.heuristic = heuristic(space),
                                                   .transition = transition(),
                                                   .trail = Trail<Store>(std::move(store), trail_rule()),
                                                   .deposit = deposit(),
                                                   .local_search = local_search()},
                                          {.ants = static_cast<std::size_t>(values_.integer("ants")),
                                           .iterations = static_cast<std::uint64_t>(values_.integer("iterations")),
                                           .alpha = static_cast<int>(values_.integer("alpha")),
                                           .follow = values_.number("follow"),
                                           .give_up = values_.number("give_up"),
                                           .end_within_m = end_within_m(space),
                                           .step_backs = static_cast<std::size_t>(values_.integer("step_backs"))});
    if (const SearchResult first = first_route(space, run); first.found) colony.start_from(first.actions, run);
    const Ant& best = colony.run(run);
    history = colony.history();
    return {.found = best.arrived(),
            .actions = {best.actions.begin(), best.actions.end()},
            .cost = best.cost,
            .expansions = colony.moves(),
            .candidates = colony.moves() * space.actions()};
  }

  /// A route for ants to follow: the greedy walk, and what a few narrow passes of beam search make of it (Beam-ACO:
  /// Blum 2005). Each pass counts as an iteration.
  SearchResult first_route(const AttitudeAnts& space, RunContext& run) const {
    const std::string& kind = values_.text("first_route");
    if (kind == "none") return {};
    SearchResult greedy = greedy_walk(space, run);
    if (kind == "greedy") return greedy;
    const std::uint64_t passes = beam_passes(space, greedy.found);
    const BeamOptions options{.max_width = BeamOptions{}.width << (passes - 1), .default_passes = passes};
    return Beam(space.lattice(), options).run(run, std::move(greedy));
  }

  /// In the node model, whose costs know of the goal, the cheaper of the walks by J and by J + h.
  static SearchResult greedy_walk(const AttitudeAnts& space, RunContext& run) {
    SearchResult greedy = Greedy(space.lattice(), GreedyOptions{.max_step_backs = 500}).run(run);
    if (!space.in_single_precision()) return greedy;
    SearchResult by_cost = Greedy(space.lattice(), {.use_guide = false, .max_step_backs = 500}).run(run);
    return by_cost.cost < greedy.cost ? by_cost : greedy;
  }

  std::uint64_t beam_passes(const AttitudeAnts& space, bool is_bounded) const {
    constexpr std::uint64_t kElsewhere = 4;
    constexpr std::uint64_t kAmongNodes = 3;  // from there on the ants, priced in single precision, gain more
    constexpr std::uint64_t kUnbounded = 1;   // without a route to beat a pass goes on to the step limit
    if (const std::int64_t passes = values_.integer("beam_passes"); passes > 0)
      return static_cast<std::uint64_t>(passes);
    if (!space.in_single_precision()) return kElsewhere;
    return is_bounded ? kAmongNodes : kUnbounded;
  }

  /// How near the goal must have been for an ant that flies past it to end.
  float end_within_m(const AttitudeAnts& space) const {
    constexpr float kSteps = 2;
    return values_.text("overshoot") == "end" ? kSteps * space.step_m() : 0;
  }

  AnyHeuristic heuristic(const AttitudeAnts& space) const {
    if (values_.text("heuristic") == "1/J") return {PowerHeuristic{static_cast<int>(values_.integer("beta"))}};
    return {GoalDirected(values_.number("temperature") * space.step_price(), values_.number("spread"),
                         static_cast<std::size_t>(values_.integer("ants")))};
  }

  AnyTransition transition() const {
    const double q0 = values_.number("q0");
    if (q0 > 0) return {PseudoRandom{q0}};
    return {Roulette{}};
  }

  TrailRule trail_rule() const {
    const bool max_min = values_.text("deposit") == "max-min";
    const bool worn_locally = values_.text("deposit") == "acs";
    return {.evaporation = worn_locally ? 0 : values_.number("evaporation"), .unknown_decays = max_min};
  }

  AnyDeposit deposit() const {
    const std::string& name = values_.text("deposit");
    const double q = values_.number("q");
    const double evaporation = values_.number("evaporation");
    if (name == "ant-system") return {AntSystem{q}};
    if (name == "rank") return {RankBased{q, static_cast<std::size_t>(values_.integer("rank_w"))}};
    if (name == "max-min")
      return {MaxMin{.q = q,
                     .evaporation = evaporation,
                     .ratio = values_.number("trail_ratio"),
                     .best_every = static_cast<std::uint64_t>(values_.integer("best_every"))}};
    if (name == "acs") return {ColonySystem{.q = q, .evaporation = evaporation, .wear = values_.number("wear")}};
    return {NoDeposit{}};
  }

  AnyLocalSearch local_search() const {
    if (values_.text("local_search") == "none") return {NoLocalSearch{}};
    return {ActionString{.pair_distance = static_cast<std::size_t>(values_.integer("pair_distance")),
                         .pair_margin = values_.number("pair_margin")}};
  }

  ParamValues values_;
};

}  // namespace

PlannerEntry attitude_aco_entry() {
  return {.name = "attitude-aco",
          .help = "An ant colony that picks rotations of the aircraft: as published in 2019, and made good.",
          .can = {.anytime = true, .terrain = true, .threats = true, .space = "attitude lattice"},
          .presets = attitude_aco_presets(),
          .parameters = ParamTable(attitude_aco_parameters()),
          .refuses = attitude_refusal,
          .make = [](const ParamValues& values) { return Planner(AttitudeAco(values)); }};
}

}  // namespace alate
