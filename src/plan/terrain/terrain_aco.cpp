// Ants on a terrain lattice: Mai et al. 2023, its baseline, and a colony made good.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp. What of the paper is verbatim, partly read or
// reconstructed is said at each policy and in the parameters' sources.
#include <algorithm>

#include "aco/colony.hpp"
#include "aco/deposit/bounded_ant_system.hpp"
#include "aco/deposit/dual_strategy.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/heuristic/lattice_goal.hpp"
#include "aco/heuristic/terrain_factors.hpp"
#include "aco/local_search/corridor.hpp"
#include "aco/one_of.hpp"
#include "aco/transition/lattice_table.hpp"
#include "aco/walk/lattice_walk.hpp"
#include "plan/attitude/lattice_parameters.hpp"
#include "plan/terrain/terrain_aco_parameters.hpp"
#include "plan/terrain/terrain_plan.hpp"
#include "plan/terrain/terrain_planners.hpp"
#include "space/taut_route.hpp"

namespace alate {

namespace {

using AnyDeposit = OneOf<MaxMin, DualStrategy, BoundedAntSystem>;

/// What is done to the best ant of an iteration; and where good ants lead to off the lattice. Costs on the lattice know
/// few directions, so the ant that leads to the best route need not be the best one.
class Polish {
 public:
  struct Kept {
    std::vector<Vec3> places;
    double cost = kInfinity;
  };

  /// `taut`: null to stay on the lattice; it and `kept` must outlive this.
  Polish(bool in_corridor, const TautRoute* taut, Kept* kept) : in_corridor_(in_corridor), taut_(taut), kept_(kept) {}

  bool operator()(const TerrainLattice& lattice, Ant& ant, double best, RunContext& run) {
    const bool changed = in_corridor_ && improve(lattice, ant, run);
    if (taut_ != nullptr && ant.cost < best * (1 + kNear) && is_new(ant.cost)) pull(lattice, ant, run);
    return changed;
  }

 private:
  bool improve(const TerrainLattice& lattice, Ant& ant, RunContext& run) {
    std::vector<std::uint32_t> actions = ant.actions;
    if (!corridor_(lattice, actions, run)) return false;
    const auto flight = lattice.fly(actions);
    if (!flight || !(flight->cost < ant.cost)) return false;
    ant.actions = std::move(actions);
    ant.cost = flight->cost;
    return true;
  }

  void pull(const TerrainLattice& lattice, const Ant& ant, RunContext& run) const {
    const double step = lattice.frame().steps_m().x();
    std::vector<Vec3> places = taut_->pull(lattice.places(ant.actions), step, run);
    const double cost = taut_->cost(places);
    if (cost < kept_->cost) *kept_ = {.places = std::move(places), .cost = cost};
  }

  static constexpr double kNear = 0.03;

  /// Routes of one cost are taken for one route.
  bool is_new(double cost) {
    const auto place = std::ranges::lower_bound(seen_, cost);
    if (place != seen_.end() && *place == cost) return false;
    seen_.insert(place, cost);
    return true;
  }

  bool in_corridor_;
  const TautRoute* taut_;
  Kept* kept_;
  Corridor corridor_;
  std::vector<double> seen_;  ///< Costs of routes that were pulled, in order.
};

using Policies = LatticePolicies<LatticeTable, AnyDeposit, Polish>;

class TerrainAco {
 public:
  explicit TerrainAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_over_terrain(problem, run, lattice_options(values_),
                             [&](const TerrainLattice& lattice) { return fly_colony(lattice, problem.world, run); });
  }

 private:
  bool is(std::string_view name, std::string_view value) const { return values_.text(name) == value; }
  double number(std::string_view name) const { return values_.number(name); }
  int integer(std::string_view name) const { return static_cast<int>(values_.integer(name)); }
  std::uint64_t count(std::string_view name) const { return static_cast<std::uint64_t>(values_.integer(name)); }

  LatticeFound fly_colony(const TerrainLattice& lattice, const World& world, RunContext& run) const {
    LatticeFound found;
    const TautRoute taut(world);
    Polish::Kept kept;
    const bool on_nodes = is("trail_on", "nodes");
    const LatticeCells cells(lattice.frame(), on_nodes ? LatticeCells::On::nodes : LatticeCells::On::edges);
    Colony<TerrainLattice, Policies> colony(
        lattice,
        Policies{.choice = LatticeTable(lattice, heuristic(lattice), table_rule()),
                 .trail = Trail<LatticeCells>(cells, trail_rule()),
                 .deposit = deposit(),
                 .local_search = Polish(is("local_search", "corridor"), is("polish", "taut") ? &taut : nullptr, &kept)},
        {.ants = count("ants"), .iterations = count("iterations"), .follow = number("follow"), .tally = &found.tally});
    const Ant& best = colony.run(run);
    if (best.arrived()) found.places = kept.places.empty() ? lattice.places(best.actions) : kept.places;
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
