// Ants on a terrain lattice: Mai et al. 2023, its baseline, and a colony made good.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp. What of the paper is verbatim, partly read or
// reconstructed is said at each policy and in the parameters' sources.
#include "aco/colony.hpp"
#include "aco/deposit/bounded_ant_system.hpp"
#include "aco/deposit/dual_strategy.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/heuristic/lattice_goal.hpp"
#include "aco/heuristic/terrain_factors.hpp"
#include "aco/local_search/none.hpp"
#include "aco/one_of.hpp"
#include "aco/transition/lattice_table.hpp"
#include "aco/walk/lattice_walk.hpp"
#include "plan/terrain_aco_parameters.hpp"
#include "plan/terrain_plan.hpp"
#include "plan/terrain_planners.hpp"

namespace alate {

namespace {

using AnyDeposit = OneOf<MaxMin, DualStrategy, BoundedAntSystem>;
using Policies = LatticePolicies<LatticeTable, AnyDeposit, NoLocalSearch>;

class TerrainAco {
 public:
  explicit TerrainAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_over_terrain(
        problem, run, {.steps = steps(), .rules = rules(), .score = score()},
        {.search = [&](const TerrainLattice& lattice) { return fly_colony(lattice, run); }, .polish = {}});
  }

 private:
  bool is(std::string_view name, std::string_view value) const { return values_.text(name) == value; }
  double number(std::string_view name) const { return values_.number(name); }
  int integer(std::string_view name) const { return static_cast<int>(values_.integer(name)); }
  std::uint64_t count(std::string_view name) const { return static_cast<std::uint64_t>(values_.integer(name)); }
  double limit(std::string_view name) const { return number(name) > 0 ? number(name) : kInfinity; }

  LatticeSteps steps() const {
    MainDirection main = MainDirection::automatic;
    if (is("main_direction", "x")) main = MainDirection::x;
    if (is("main_direction", "y")) main = MainDirection::y;
    return {.main = main,
            .main_m = number("step_m"),
            .side_m = number("side_m"),
            .height_m = number("height_m"),
            .window_side = integer("window_side"),
            .window_height = integer("window_height")};
  }

  LatticeRules rules() const {
    return {.limits = {.length_m = limit("length_max_m"),
                       .leg_m = number("leg_min_m"),
                       .height_agl_m = number("height_min_agl_m"),
                       .height_amsl_m = limit("height_max_m"),
                       .pitch_rad = radians(number("pitch_max_deg")),
                       .turn_rad = radians(number("turn_max_deg"))},
            .filters = is("constraints", "filter"),
            .safe_agl_m = number("safe_height_m"),
            .whole_legs = is("safety", "leg"),
            .any_join = is("join", "any"),
            .prunes = is("dead_ends", "pruned")};
  }

  TerrainScore score() const {
    using Score = TerrainScore;
    return {.rule = is("fitness", "paper") ? Score::Rule::paper : Score::Rule::objective,
            .length = number("weight_length"),
            .height = number("weight_height"),
            .turn = number("weight_turn"),
            .datum = is("height_above", "ground") ? Score::Datum::ground : Score::Datum::sea,
            .degrees = is("angle_unit", "deg"),
            .penalty = number("penalty")};
  }

  LatticeFound fly_colony(const TerrainLattice& lattice, RunContext& run) const {
    LatticeFound found;
    const LatticeCells cells(lattice.frame(),
                             is("trail_on", "nodes") ? LatticeCells::On::nodes : LatticeCells::On::edges);
    Colony<TerrainLattice, Policies> colony(
        lattice,
        Policies{.choice = LatticeTable(lattice, heuristic(lattice), table_rule()),
                 .trail = Trail<LatticeCells>(cells, trail_rule()),
                 .deposit = deposit(),
                 .local_search = {}},
        {.ants = count("ants"), .iterations = count("iterations"), .follow = number("follow"), .tally = &found.tally});
    const Ant& best = colony.run(run);
    found.found = best.arrived();
    found.actions = best.actions;
    found.moves = colony.moves();
    found.history = colony.history();
    return found;
  }

  AlignedFloats heuristic(const TerrainLattice& lattice) const {
    if (is("heuristic", "goal-directed")) return lattice_directed_table(lattice, number("temperature"));
    if (is("heuristic", "goal-distance")) return lattice_distance_table(lattice, integer("beta"));
    return terrain_factor_table(
        lattice, {.beta = integer("beta"),
                  .unit = is("factor_unit", "km") ? TerrainFactorRule::Unit::km : TerrainFactorRule::Unit::cells,
                  .literal_one = is("unit_step", "literal")});
  }

  bool evaporates_on_path() const { return is("deposit", "dual") && is("evaporation_scope", "path"); }

  LatticeTableRule table_rule() const {
    return {.alpha = integer("alpha"),
            .q0 = {.initial = number("q0"), .is_constant = is("q0_schedule", "constant")},
            .bounded = !is("deposit", "ant-system") && !evaporates_on_path()};
  }

  TrailRule trail_rule() const {
    return {.evaporation = evaporates_on_path() ? 0 : number("evaporation"),
            .initial = number("trail_start"),
            .unknown_decays = true};
  }

  AnyDeposit deposit() const {
    const double q = number("q");
    const double evaporation = number("evaporation");
    if (is("deposit", "max-min"))
      return {MaxMin{
          .q = q, .evaporation = evaporation, .ratio = number("trail_ratio"), .best_every = count("best_every")}};
    if (is("deposit", "dual")) return {dual(q, evaporation)};
    const auto over = is("deposit_over", "length") ? BoundedAntSystem::Over::length : BoundedAntSystem::Over::score;
    return {BoundedAntSystem{.q = q,
                             .evaporation = evaporation,
                             .decay = 1,
                             .least_evaporation = evaporation,
                             .least = 0,
                             .most = kUnbounded,
                             .over = over}};
  }

  DualStrategy dual(double q, double evaporation) const {
    return {.q = q,
            .evaporation = evaporation,
            .least = number("trail_min"),
            .most = number("trail_max"),
            .lambda = number("lambda"),
            .gamma = number("lambda_decay"),
            .every = count("lambda_every"),
            .on_path = evaporates_on_path(),
            .each_ant = is("fitness_current", "each-ant")};
  }

  static constexpr double kUnbounded = 1e30;

  ParamValues values_;
};

}  // namespace

PlannerEntry terrain_aco_entry() {
  return {.name = "terrain-aco",
          .help =
              "An ant colony that steps from plane to plane of a lattice over terrain: as published in 2023, and made "
              "good.",
          .can = {.anytime = true, .terrain = true, .threats = true, .space = "terrain lattice"},
          .presets = terrain_aco_presets(),
          .parameters = ParamTable(terrain_aco_parameters()),
          .refuses = terrain_refusal,
          .make = [](const ParamValues& values) { return Planner(TerrainAco(values)); }};
}

}  // namespace alate
