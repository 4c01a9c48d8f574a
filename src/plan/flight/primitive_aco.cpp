// Ants on the pieces of the interval search: true arcs and straight pieces over real ground, altitudes as intervals.
//
// Every preset is a row of parameter values; the loop is aco/colony.hpp. What an ant has found is told as actions; so
// is what became of it by local changes, which leave the primitives (FlightAnts::learn): ants can follow that as well,
// and trails lie along it.
#include <algorithm>

#include "aco/colony.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/heuristic/goal_directed.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/roulette.hpp"
#include "plan/flight/flight_bound.hpp"
#include "plan/flight/flight_ends.hpp"
#include "plan/flight/flight_plan.hpp"
#include "plan/flight/flight_planners.hpp"
#include "plan/flight/primitive_aco_parameters.hpp"
#include "search/interval/flight_ants.hpp"
#include "search/interval/flight_pool.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/flight/flight_air.hpp"

namespace alate {

namespace {

/// Everything of one problem but the colony itself, and the best flight so far.
class FlightWork {
 public:
  FlightWork(const Problem& problem, RunContext& run, const ParamValues& values, Plan& plan)
      : problem_(problem),
        plan_(plan),
        air_(problem.world),
        to_go_(air_.world, air_.band.slopes(), run),
        end_(flight_end(problem.mission.goal, problem.mission.tolerance_m)),
        bin_m_(bin_width((problem.mission.goal - problem.mission.start).norm(), air_.band.radius_m())),
        space_(air_.cost, to_go_, {flight_start(problem.mission), end_},
               {.bin_m = bin_m_, .ahead_m = values.number("look_ahead") * air_.band.radius_m()}),
        random_(run.seed(), 0, 0),
        pool_(static_cast<int>(values.integer("trials")), kApart * bin_m_) {}

  FlightAnts& space() { return space_; }
  double bin_price() const { return bin_m_ * air_.cost.length_weight(); }

  /// One search of its own; what it finds is bettered and taken in.
  void search(double epsilon, RunContext& run) {
    IntervalAStar search(air_.cost, to_go_);
    const auto track = search.find(flight_start(problem_.mission), end_, {.epsilon = epsilon, .bin_m = bin_m_}, run);
    plan_.counters["expansions"] += search.expansions();
    if (track) better(*track, run);
  }

  /// Takes in a track, if there is any, and works on with those that are there.
  void better(const Track& track, RunContext& run) {
    if (!track.empty())
      pool_.add_bettered(FlightPath(air_.cost, end_, track, problem_.mission.start.z()), random_, run);
    pool_.better(random_, run);
    if (!pool_.empty()) keep(pool_.best().track(), pool_.best().end());
    run.report(plan_.route.empty() ? std::nullopt : std::optional(plan_.cost));
  }

  /// Altitudes for a track; the flight is kept if it is the best so far.
  bool keep(const Track& track, const FlightEnd& end) {
    auto route = fly_track(air_.cost, track, problem_.mission.start, end);
    if (!route) return false;
    const double cost = air_.objective.route_cost(*route);
    keep_if_better(air_.world.site(), std::move(*route), cost, plan_);
    return true;
  }

  /// The best way of all as actions, if it costs less than `most`.
  std::optional<std::vector<std::uint32_t>> best_as_actions(double most) {
    if (pool_.empty() || pool_.best().cost() >= most) return std::nullopt;
    return space_.learn(pool_.best().track(), pool_.best().end());
  }

 private:
  static constexpr double kApart = 3;  ///< Bins; of ways that are nearer to each other only one is bettered.

  const Problem& problem_;
  Plan& plan_;
  FlightAir air_;
  ClimbField to_go_;
  FlightEnd end_;
  double bin_m_;
  FlightAnts space_;
  Stream random_;
  FlightPool pool_;
};

/// What becomes of the best ant of an iteration.
struct FlightChanges {
  FlightWork* work = nullptr;
  bool changes = true;  ///< Or its way is flown as it is.

  bool operator()(const FlightAnts& space, Ant& ant, double best, RunContext& run) const {
    const Track walked = space.track(ant.actions);
    if (!changes) {
      if (ant.cost < best && !work->keep(joined(walked), space.end())) work->keep(walked, space.end());
      return false;
    }
    const bool is_new = !FlightAnts::is_known(ant.actions.back());
    if (!is_new && !(best < kInfinity)) return false;  // what the colony starts from has been bettered already
    work->better(is_new ? joined(walked) : Track{}, run);
    const double most = std::min(ant.cost, best);
    const auto actions = work->best_as_actions(most);
    const auto flight = actions ? space.fly(*actions) : std::nullopt;
    // Pieces cost a little more than the whole: what is not the best for the ants must not take the place of what is.
    if (!flight || !(flight->cost < most)) return false;
    work->space().keep_learnt();
    ant.actions = *actions;
    ant.cost = flight->cost;
    ant.costs = flight->costs;
    return true;
  }
};

using FlightTrail = Trail<HashCells>;
using Policies = ColonyPolicies<GoalDirected, Roulette, FlightTrail, MaxMin, FlightChanges>;

class PrimitiveAco {
 public:
  explicit PrimitiveAco(ParamValues values) : values_(std::move(values)) {}

  Plan plan(const Problem& problem, RunContext& run) const {
    return plan_flight(problem, run, "no ant arrived at the goal", [&](Plan& plan) {
      FlightWork work(problem, run, values_, plan);
      fly_colony(work, plan, run);
      if (run.keep_going()) note_bound(problem, BoundEffort::quick, run, plan);
    });
  }

 private:
  std::size_t count(std::string_view name) const { return static_cast<std::size_t>(values_.integer(name)); }

  void fly_colony(FlightWork& work, Plan& plan, RunContext& run) const {
    if (values_.text("first_route") == "search")
      for (const double epsilon : {2.5, 1.15})
        if (run.start_iteration(count("iterations"))) work.search(epsilon, run);
    const auto known = work.best_as_actions(kInfinity);
    const std::vector<std::uint32_t> first = known.value_or(std::vector<std::uint32_t>{});
    Colony<FlightAnts, Policies> colony(work.space(), policies(work, first), options());
    if (known) {
      work.space().keep_learnt();
      colony.start_from({first.begin(), first.end()}, run);
    }
    colony.run(run);
    plan.counters["moves"] += colony.moves();
    plan.history = colony.history();
  }

  ColonyOptions options() const {
    return {.ants = count("ants"),
            .iterations = count("iterations"),
            .alpha = static_cast<int>(values_.integer("alpha")),
            .follow = values_.number("follow"),
            .give_up = values_.number("give_up"),
            .step_backs = count("step_backs")};
  }

  Policies policies(FlightWork& work, const std::vector<std::uint32_t>& known) const {
    const double temperature = values_.number("temperature") * work.bin_price();
    MaxMin deposit{.q = 1,  // bounds are in proportion to it: any would do
                   .evaporation = values_.number("evaporation"),
                   .ratio = values_.number("trail_ratio"),
                   .best_every = count("best_every")};
    FlightTrail trail = first_trail(work.space(), known, deposit);
    return {.heuristic = GoalDirected(temperature, values_.number("spread"), count("ants")),
            .transition = Roulette{},
            .trail = std::move(trail),
            .deposit = deposit,
            .local_search = {.work = &work, .changes = values_.text("local_search") == "changes"}};
  }

  /// Moves of a flight that is known have the highest trail from the first, all others the lowest.
  static FlightTrail first_trail(const FlightAnts& space, const std::vector<std::uint32_t>& known, MaxMin& deposit) {
    constexpr double kName = 1;  // names of moves are whole numbers
    FlightTrail trail(HashCells(kName), {.evaporation = deposit.evaporation, .unknown_decays = true});
    const auto flight = space.fly(known);
    if (!flight) return trail;
    const double most = deposit.q / (deposit.evaporation * flight->cost);
    trail.levels().set_bounds(most / deposit.ratio, most);
    trail.levels().set_unknown(most / deposit.ratio);
    Ant ant;
    ant.actions = known;
    trail.name_route(space, ant);
    for (const TrailKey move : ant.keys) trail.add(move, most);
    deposit.started = true;
    return trail;
  }

  ParamValues values_;
};

}  // namespace

PlannerEntry primitive_aco_entry() {
  return {.name = "primitive-aco",
          .help = "An ant colony on the Dubins pieces of interval-astar, from its answer or from nothing.",
          .can = {.anytime = true, .terrain = true, .threats = true, .space = "Dubins flight"},
          .presets = primitive_aco_presets(),
          .parameters = ParamTable(primitive_aco_parameters()),
          .refuses = interval_astar_entry().refuses,
          .make = [](const ParamValues& values) { return Planner(PrimitiveAco(values)); }};
}

}  // namespace alate
