// The flagship: a fixed wing over real ground, by true Dubins pieces and intervals of altitude.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "plan/flight_bound.hpp"
#include "plan/flight_planners.hpp"
#include "search/interval/flight_path.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/lower_bound.hpp"
#include "space/objective.hpp"

namespace alate {

namespace {

/// Weight of the cost-to-go, and width of bins in their usual width: one search each, the hasty one first.
struct Pass {
  double epsilon;
  double bin;
};
constexpr std::array kPasses{Pass{2.5, 1},    Pass{1.15, 1}, Pass{1.05, 1}, Pass{1.15, 0.5},
                             Pass{1.05, 0.5}, Pass{1.15, 2}, Pass{1.05, 2}};
constexpr std::uint64_t kIterations = 60;  ///< Where neither a budget nor a time limit is given.
constexpr int kTrials = 250;               ///< Of changes, an iteration.

/// All that is known of one problem while it is worked on. An iteration is a search, or a round of changes to a way
/// that one of them found.
class IntervalRun {
 public:
  IntervalRun(const Problem& problem, BoundEffort effort, RunContext& run)
      : problem_(problem),
        effort_(effort),
        run_(run),
        band_(problem.world),
        cost_(band_),
        objective_(problem.world),
        to_go_(problem.world, band_.slopes(), run),
        search_(cost_, to_go_),
        end_{.goal = problem.mission.goal, .tolerance_m = std::max(0.0, problem.mission.tolerance_m - 1e-3)},
        random_(run.seed(), 0, 0) {}

  void improve(Plan& plan) {
    while (run_.start_iteration(kIterations)) {
      if (pass_ < kPasses.size()) {
        search(plan);
      } else if (paths_.empty()) {
        return;
      } else {
        // The best one every other round, the second one every fourth, ...
        const auto rank = static_cast<std::size_t>(std::countr_zero(++rounds_));
        paths_[std::min(rank, paths_.size() - 1)].better(random_, kTrials, run_);
      }
      std::ranges::stable_sort(paths_, std::less{}, &FlightPath::cost);
      if (!paths_.empty()) fly_best(plan);
      if (run_.iterations() == 1 || (!bounded_ && !plan.route.empty())) note_bound(problem_, effort_, run_, plan);
      bounded_ = !plan.route.empty();
      if (plan.outcome == Outcome::infeasible_proven) return;
    }
  }

 private:
  std::vector<PlanarPose> starts() const {
    const Mission& mission = problem_.mission;
    const auto pose = [&](double heading) { return planar_pose(mission.start.x(), mission.start.y(), heading); };
    if (mission.heading_given) return {pose(kPi / 2 - mission.heading_rad)};
    std::vector<PlanarPose> all;
    constexpr int kHeadings = 16;
    const Vec2 way = (mission.goal - mission.start).head<2>();
    for (int k = 0; k < kHeadings; ++k) all.push_back(pose(std::atan2(way.y(), way.x()) + 2 * kPi * k / kHeadings));
    return all;
  }

  void search(Plan& plan) {
    const Pass pass = kPasses[pass_++];
    const double distance = (problem_.mission.goal - problem_.mission.start).norm();
    const double bin = std::clamp(distance / 250, band_.radius_m() / 2, 4 * band_.radius_m());
    const double z = problem_.mission.start.z();
    const auto track = search_.find({starts(), z}, end_, {.epsilon = pass.epsilon, .bin_m = bin * pass.bin}, run_);
    plan.counters["expansions"] += search_.expansions();
    if (!track) return;
    paths_.emplace_back(cost_, end_, *track, z);
    paths_.back().shorten(run_);
    paths_.back().better(random_, kTrials, run_);
  }

  /// Altitudes for the way that seems best; kept if it is.
  void fly_best(Plan& plan) {
    const FlightPath& path = paths_.front();
    if (auto route = fly_track(band_, path.track(), problem_.mission.start, path.end())) {
      const double cost = objective_.route_cost(*route);
      if (plan.route.empty() || cost < plan.cost) {
        plan.outcome = Outcome::feasible;
        plan.route = std::move(*route);
        plan.cost = cost;
      }
      run_.report(plan.cost);
    }
  }

  const Problem& problem_;
  BoundEffort effort_;
  RunContext& run_;
  BandWalk band_;
  FlightCost cost_;
  Objective objective_;
  ClimbField to_go_;
  IntervalAStar search_;
  FlightEnd end_;
  Stream random_;
  std::vector<FlightPath> paths_;
  std::size_t pass_ = 0;
  bool bounded_ = false;  ///< A route was there when the bound was last worked on.
  std::uint64_t rounds_ = 0;
};

struct IntervalPlanner {
  BoundEffort effort = BoundEffort::quick;

  Plan plan(const Problem& problem, RunContext& run) const {
    const Mission& mission = problem.mission;
    Plan plan{.lower_bound = physical_bound(problem.world.site(), mission.start), .seed = run.seed()};
    if ((mission.goal - mission.start).norm() <= mission.tolerance_m) {
      plan.outcome = Outcome::feasible;
      plan.route.states = {{.position = mission.start, .leg = LegKind::start}};
    } else {
      note_barrier(problem, run, plan);
      if (plan.outcome != Outcome::infeasible_proven) IntervalRun(problem, effort, run).improve(plan);
    }
    plan.counters["iterations"] = run.iterations();
    plan.stop = run.stop();
    const bool stopped = plan.stop == Stop::deadline || plan.stop == Stop::cancelled;
    plan.reproducible = !stopped;
    if (plan.route.empty() && plan.why.empty())
      plan.why =
          stopped ? "stopped before any route was found" : "no string of arcs and straight pieces leads to the goal";
    return plan;
  }
};

std::string refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.grid || site.voxels) return "flies through the air, not from cell to cell; take jps, or leave out grid";
  if (site.navigation) return "knows nothing of navigation errors; take label-setting, or leave out navigation";
  if (!problem.vehicle.turn_radius_m || *problem.vehicle.turn_radius_m <= 0)
    return "flies circles; add vehicle.turn_radius_m";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  return "";
}

}  // namespace

PlannerEntry interval_astar_entry() {
  return {
      .name = "interval-astar",
      .help = "Dubins pieces over real ground, altitudes as intervals; then bettered until the time is up.",
      .can = {.anytime = true, .deterministic = false, .terrain = true, .threats = true, .space = "Dubins flight"},
      .presets = {{.name = "default", .help = "As the table says."}},
      .parameters = ParamTable(
          {{.name = "bound",
            .default_value = std::string("quick"),
            .choices = {"quick", "tight"},
            .help = "Work on the lower bound: about 10 ms, or some tenths of a second of the time there is (--bound).",
            .source = "alate"}}),
      .refuses = refusal,
      .make = [](const ParamValues& values) {
        return Planner(IntervalPlanner{values.text("bound") == "tight" ? BoundEffort::tight : BoundEffort::quick});
      }};
}

}  // namespace alate
