// A fixed wing over real ground where navigation drifts: which correction points to fly over, and how.
//
// The cheapest sequence of points is found as if legs not flown yet were straight (label-setting); its legs are flown
// one after the other by the interval search, each beginning in the heading that the one before ended with; what they
// are long in truth takes the place of the straight lines, and the sequence is found anew, until it is one that has
// been flown. Straight lines are never longer, so no other sequence of such legs is cheaper then.
#include <algorithm>
#include <map>

#include "plan/flight/correction_legs.hpp"
#include "plan/flight/flight_plan.hpp"
#include "plan/flight/flight_planners.hpp"
#include "search/flown_sequence.hpp"
#include "search/label_setting/gap.hpp"
#include "search/label_setting/shortest.hpp"
#include "space/lower_bound.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr std::uint64_t kRounds = 200;  ///< Where neither a budget nor a time limit is given.
/// Lengths are summed in another order by others.
constexpr double kRoundingShare = 1e-9;

class CorrectionFlight {
 public:
  CorrectionFlight(const Problem& problem, RunContext& run, Plan& plan)
      : problem_(problem),
        run_(run),
        plan_(plan),
        graph_(*problem.world.site().navigation, problem.mission.start, problem.mission.goal),
        legs_(problem.world.site(), run) {}

  void improve() {
    if (!note_bound()) return;
    while (run_.start_iteration(kRounds)) {
      const auto sequence = cheapest_sequence(
          graph_, flown_, {.metre_cost = problem_.objective.length, .goal_within_m = problem_.mission.tolerance_m},
          run_);
      if (!sequence || *sequence == whole_) return;
      if (!fly(*sequence)) return;
      run_.report(plan_.route.empty() ? std::nullopt : std::optional(plan_.cost));
    }
  }

 private:
  /// Straight legs over free air are the shortest that there are. False if even they lead nowhere.
  bool note_bound() {
    const CorrectionGraph graph(with_near_goal(), problem_.mission.start, problem_.mission.goal);
    const ShortestResult straight = shortest_route(graph, {}, run_);
    if (straight.stopped) return false;
    if (!straight.route) {
      plan_.outcome = Outcome::infeasible_proven;
      plan_.lower_bound = 0;
      plan_.why = describe_gap(graph, run_);
      return false;
    }
    const double least_m = straight.bound_m - problem_.mission.tolerance_m;
    plan_.lower_bound = std::max(plan_.lower_bound, problem_.objective.length * least_m);
    return true;
  }

  /// A flight may end before the goal, as near as is tolerated: its last leg is so much shorter than one to the goal,
  /// and its errors less.
  Navigation with_near_goal() const {
    Navigation navigation = *problem_.world.site().navigation;
    navigation.theta += std::max(navigation.drift_vertical, navigation.drift_horizontal) * problem_.mission.tolerance_m;
    return navigation;
  }

  /// Leg by leg, as far as errors allow; the flight is kept if it arrives and is the best. False if `run` ends it.
  bool fly(const std::vector<Node>& sequence) {
    std::vector<const FlownLeg*> way;
    double error = 0;
    for (std::size_t i = 1; i < sequence.size(); ++i) {
      const auto& leg = leg_to({sequence.begin(), sequence.begin() + static_cast<std::ptrdiff_t>(i) + 1}, way);
      if (!run_.keep_going() && !leg) return false;
      const Node before = sequence[i < 2 ? 0 : i - 2];
      const double length = leg ? leg->length_m * (1 + kRoundingShare) : kInfinity;
      flown_.note(before, sequence[i - 1], sequence[i], {.length_m = length, .cost = leg ? leg->cost : kInfinity});
      const ReducedLeg& rule = graph_.leg(sequence[i - 1], sequence[i]);
      if (!leg || !rule.keeps_limits(error, length)) return true;
      error = rule.after(error, length);
      way.push_back(&*leg);
    }
    whole_ = sequence;
    keep(sequence, way);
    return true;
  }

  /// The last leg of a way, flown once.
  const std::optional<FlownLeg>& leg_to(const std::vector<Node>& nodes, const std::vector<const FlownLeg*>& way) {
    const auto [place, is_new] = known_.try_emplace(nodes);
    if (!is_new) return place->second;
    const Node to = nodes.back();
    FlightStart start = flight_start(problem_.mission);
    if (!way.empty())
      start = {.poses = {way.back()->end}, .label = AltitudeLabel::at(graph_.position(nodes[nodes.size() - 2]).z())};
    const double tolerance_m = to == graph_.goal() ? problem_.mission.tolerance_m : 0;
    place->second = legs_.fly(start, static_cast<int>(to), graph_.position(to), tolerance_m);
    ++plan_.counters["legs"];
    return place->second;
  }

  void keep(const std::vector<Node>& sequence, const std::vector<const FlownLeg*>& way) {
    double cost = 0;
    for (const FlownLeg* leg : way) cost += leg->cost;
    Route route{.states = {way.front()->route.states.front()}};
    for (std::size_t i = 0; i < way.size(); ++i) {
      const auto& states = way[i]->route.states;
      route.states.insert(route.states.end(), states.begin() + 1, states.end());
      if (sequence[i + 1] != graph_.goal()) route.states.back().point_id = graph_.id(sequence[i + 1]);
    }
    keep_if_better(problem_.world.site(), std::move(route), cost, plan_);
  }

  const Problem& problem_;
  RunContext& run_;
  Plan& plan_;
  CorrectionGraph graph_;
  CorrectionLegs legs_;
  FlownLegs flown_;
  std::map<std::vector<Node>, std::optional<FlownLeg>> known_;  ///< The last leg of each way that was begun.
  std::vector<Node> whole_;                                     ///< The sequence that was flown whole last.
};

struct CorrectionFlightPlanner {
  static Plan plan(const Problem& problem, RunContext& run) {
    Plan plan{.lower_bound = physical_bound(problem.world.site(), problem.mission.start), .seed = run.seed()};
    if (run.keep_going()) CorrectionFlight(problem, run, plan).improve();
    conclude_flight(plan, run,
                    "no sequence of correction points was found whose legs can be flown within the error limits");
    return plan;
  }
};

std::string refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (!site.navigation) return "flies from correction point to correction point; add navigation";
  if (site.navigation->turn_model != TurnModel::none)
    return "turns on vehicle.turn_radius_m; leave out navigation.turn_model";
  if (!problem.vehicle.turn_radius_m || *problem.vehicle.turn_radius_m <= 0)
    return "flies circles; add vehicle.turn_radius_m, or take label-setting";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  if (problem.front || problem.prefer != Preference::length)
    return "knows of cost alone, not of corrections and probabilities; leave out --front and --prefer";
  return "";
}

}  // namespace

PlannerEntry correction_flight_entry() {
  return {
      .name = "interval-astar",
      .help = "Where navigation drifts, from correction point to correction point.",
      .can = {.anytime = true, .deterministic = false, .terrain = true, .threats = true, .space = "correction flight"},
      .presets = {{.name = "default", .help = "It has no parameters."}},
      .parameters = ParamTable(std::vector<Parameter>{}),
      .refuses = refusal,
      .make = [](const ParamValues&) { return Planner(CorrectionFlightPlanner{}); }};
}

}  // namespace alate
