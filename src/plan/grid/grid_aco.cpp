// Ants on a height grid: Li et al. 2019, Yin et al. 2021, the textbook colonies, and a colony made good.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp. What of the papers is as published, stated in
// prose only, or reconstructed is said at each policy and in the parameters' sources. `improved` searches by ants and
// local search alone: it knows no exact search and no distances but straight ones.
#include <numbers>

#include "aco/colony.hpp"
#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/bounded_ant_system.hpp"
#include "aco/deposit/colony_system.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/deposit/rank_based.hpp"
#include "aco/heuristic/goal_table.hpp"
#include "aco/heuristic/multi_factor.hpp"
#include "aco/local_search/none.hpp"
#include "aco/local_search/sight.hpp"
#include "aco/one_of.hpp"
#include "aco/transition/move_table.hpp"
#include "aco/walk/grid_walk.hpp"
#include "plan/grid/grid_aco_parameters.hpp"
#include "plan/grid/grid_plan.hpp"
#include "plan/grid/grid_planners.hpp"

namespace alate {

namespace {

using AnyDeposit = OneOf<MaxMin, AntSystem, RankBased, ColonySystem, BoundedAntSystem>;
using AnyLocalSearch = OneOf<NoLocalSearch, Sight>;

class GridAco {
 public:
  explicit GridAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_on_grid(problem, run, grid_options(), [&](const GridSpace& space) {
      if (is("heuristic", "multi-factor")) return fly_colony(space, MultiFactor(space, factor_rule()), run);
      return fly_colony(space, MoveTable(table(space), integer("alpha"), values_.number("q0")), run);
    });
  }

 private:
  bool is(std::string_view name, std::string_view value) const { return values_.text(name) == value; }
  int integer(std::string_view name) const { return static_cast<int>(values_.integer(name)); }
  std::size_t count(std::string_view name) const { return static_cast<std::size_t>(values_.integer(name)); }

  GridOptions grid_options() const {
    return {.diagonal = is("diagonal", "1.4") ? 1.4 : std::numbers::sqrt2,
            .score = {
                .height_dev = values_.number("weight_height"),
                .turns = values_.number("weight_turns"),
                .heights_of = is("heights_of", "matrix") ? GridScore::HeightsOf::matrix : GridScore::HeightsOf::route}};
  }

  AlignedFloats table(const GridSpace& space) const {
    if (is("heuristic", "goal-distance")) return goal_distance_table(space, integer("beta"));
    return goal_directed_table(space, values_.number("temperature"));
  }

  MultiFactorRule factor_rule() const {
    using Rule = MultiFactorRule;
    return {.alpha = integer("alpha"),
            .beta = integer("beta"),
            .omega = values_.number("omega"),
            .mu0 = values_.number("mu0"),
            .u = values_.number("u"),
            .theta = values_.number("theta"),
            .first_move = is("first_move", "shared") ? Rule::FirstMove::shared : Rule::FirstMove::straight,
            .range = is("smoothness_range", "signed") ? Rule::Range::signed_heights : Rule::Range::absolute_heights,
            .join = is("join", "sum") ? Rule::Join::sum : Rule::Join::product,
            .step_factor = values_.flag("step_factor"),
            .mu_power = integer("mu_power"),
            .mu_place = is("mu_place", "beside") ? Rule::MuPlace::beside : Rule::MuPlace::inside,
            .a = values_.number("mu_start"),
            .b = values_.number("mu_goal")};
  }

  template <class Choice>
  GridFound fly_colony(const GridSpace& space, Choice choice, RunContext& run) const {
    using Policies = GridPolicies<Choice, AnyDeposit, AnyLocalSearch>;
    Colony<GridSpace, Policies> colony(space,
                                       Policies{.choice = std::move(choice),
                                                .trail = Trail<MoveCells>(MoveCells(space.cells()), trail_rule()),
                                                .deposit = deposit(),
                                                .local_search = local_search()},
                                       {.ants = count("ants"),
                                        .iterations = static_cast<std::uint64_t>(values_.integer("iterations")),
                                        .follow = values_.number("follow"),
                                        .give_up = values_.number("give_up"),
                                        .step_backs = count("step_backs"),
                                        .repeat_best = values_.flag("repeat_best")});
    const Ant& best = colony.run(run);
    return {.found = best.arrived(), .directions = best.actions, .moves = colony.moves(), .history = colony.history()};
  }

  /// On grids every trail evaporates, that of moves nobody took yet as well; only acs wears trails by use alone.
  TrailRule trail_rule() const {
    const bool worn_locally = is("deposit", "acs");
    return {.evaporation = worn_locally ? 0 : values_.number("evaporation"),
            .initial = values_.number("trail_start"),
            .unknown_decays = !worn_locally};
  }

  AnyDeposit deposit() const {
    const double q = values_.number("q");
    const double evaporation = values_.number("evaporation");
    if (is("deposit", "ant-system")) return {AntSystem{q}};
    if (is("deposit", "rank")) return {RankBased{q, count("rank_w")}};
    if (is("deposit", "acs")) return {ColonySystem{.q = q, .evaporation = evaporation, .wear = values_.number("wear")}};
    if (is("deposit", "bounded")) return {bounded()};
    return {MaxMin{.q = q,
                   .evaporation = evaporation,
                   .ratio = values_.number("trail_ratio"),
                   .best_every = static_cast<std::uint64_t>(values_.integer("best_every"))}};
  }

  BoundedAntSystem bounded() const {
    using Bounded = BoundedAntSystem;
    return {.q = values_.number("q"),
            .evaporation = values_.number("evaporation"),
            .decay = values_.number("evaporation_decay"),
            .least_evaporation = values_.number("evaporation_min"),
            .least = values_.number("trail_min"),
            .most = values_.number("trail_max"),
            .bounds = is("trail_bounds", "each-trail") ? Bounded::Bounds::each_trail : Bounded::Bounds::whole_matrix,
            .over = is("deposit_over", "score") ? Bounded::Over::score : Bounded::Over::length};
  }

  AnyLocalSearch local_search() const {
    if (is("local_search", "none")) return {NoLocalSearch{}};
    return {Sight(count("reach"))};
  }

  ParamValues values_;
};

}  // namespace

PlannerEntry grid_aco_entry() {
  return {.name = "grid-aco",
          .help = "An ant colony that steps from cell to cell of a grid: as published in 2019 and 2021, and made good.",
          .can = {.anytime = true, .space = "height grid"},
          .presets = grid_aco_presets(),
          .parameters = ParamTable(grid_aco_parameters()),
          .refuses = grid_refusal,
          .make = [](const ParamValues& values) { return Planner(GridAco(values)); }};
}

}  // namespace alate
