// The flagship: a fixed wing over real ground, by true Dubins pieces and intervals of altitude.
#include <cmath>

#include "plan/flight_planners.hpp"
#include "search/interval/flight_path.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/lower_bound.hpp"

namespace alate {

namespace {

struct IntervalPlanner {
  /// Weights of the cost-to-go, one search each.
  static constexpr std::array kEpsilons{2.5, 1.6, 1.3, 1.15};
  static constexpr std::uint64_t kIterations = 40;  ///< Where neither a budget nor a time limit is given.
  static constexpr int kTrials = 250;

  std::vector<PlanarPose> starts(const Mission& mission) const {
    const auto pose = [&](double heading) { return planar_pose(mission.start.x(), mission.start.y(), heading); };
    if (mission.heading_given) return {pose(kPi / 2 - mission.heading_rad)};
    std::vector<PlanarPose> all;
    constexpr int kHeadings = 16;
    const Vec2 way = (mission.goal - mission.start).head<2>();
    for (int k = 0; k < kHeadings; ++k) all.push_back(pose(std::atan2(way.y(), way.x()) + 2 * kPi * k / kHeadings));
    return all;
  }

  /// Part of the goal's ball: how much of its radius is spent on altitude.
  static FlightEnd end_of(const Mission& mission, double tilt_rad) {
    const double tolerance = std::max(0.0, mission.tolerance_m - 1e-3);
    return {.place = mission.goal.head<2>(),
            .radius_m = tolerance * std::cos(tilt_rad),
            .low = mission.goal.z() - tolerance * std::sin(tilt_rad),
            .high = mission.goal.z() + tolerance * std::sin(tilt_rad)};
  }

  Plan plan(const Problem& problem, RunContext& run) const {
    const Mission& mission = problem.mission;
    Plan plan{.lower_bound = physical_bound(problem.world.site(), mission.start), .seed = run.seed()};
    const BandWalk band(problem.world);
    const FlightCost cost(band);
    const CostToGo to_go(problem.world, run);
    IntervalAStar search(cost, to_go);
    const FlightEnd end = end_of(mission, kPi / 4);
    std::vector<FlightPath> paths;
    std::size_t passes = 0;
    Stream random(run.seed(), 0, 0);
    while (run.start_iteration(kIterations)) {
      if (passes < kEpsilons.size()) {
        const double distance = (mission.goal - mission.start).norm();
        const double bin = std::clamp(distance / 250, band.radius_m() / 2, 4 * band.radius_m());
        const auto track = search.find(starts(mission), mission.start.z(), end,
                                       {.epsilon = kEpsilons[passes++], .bin_m = bin}, run);
        plan.counters["expansions"] += search.expansions();
        if (!track) {
          if (paths.empty() && passes == kEpsilons.size()) break;
          continue;
        }
        paths.emplace_back(cost, end, *track, mission.start.z());
        paths.back().shorten(run);
        paths.back().better(random, kTrials, run);
        std::ranges::stable_sort(paths, {}, &FlightPath::cost);
      } else if (!paths.empty()) {
        paths[run.iterations() % 4 == 0 && paths.size() > 1 ? 1 : 0].better(random, kTrials, run);
        std::ranges::stable_sort(paths, {}, &FlightPath::cost);
      }
      if (!paths.empty()) run.report(paths.front().cost());
    }
    if (!paths.empty()) {
      const auto route = fly_track(band, paths.front().track(), mission.start, end);
      if (route) {
        plan.outcome = Outcome::feasible;
        plan.route = *route;
        plan.cost = paths.front().cost();
      }
    }
    plan.counters["iterations"] = run.iterations();
    plan.stop = run.stop();
    plan.reproducible = plan.stop != Stop::deadline && plan.stop != Stop::cancelled;
    return plan;
  }
};

std::string refusal(const Problem& problem) {
  const Site& site = problem.world.site();
  if (site.grid) return "flies through the air, not from cell to cell; take jps, or leave out grid";
  if (site.navigation) return "knows nothing of navigation errors; take label-setting, or leave out navigation";
  if (!problem.vehicle.turn_radius_m || *problem.vehicle.turn_radius_m <= 0)
    return "flies circles; add vehicle.turn_radius_m";
  if (problem.objective.model != CostModel::physical || problem.objective.length <= 0)
    return "looks for short routes; set objective.model to physical and objective.length above 0";
  return "";
}

}  // namespace

PlannerEntry interval_astar_entry() {
  return {.name = "interval-astar",
          .help = "Dubins pieces over real ground, altitudes as intervals; then bettered until the time is up.",
          .can = {.anytime = true, .deterministic = false, .terrain = true, .threats = true, .space = "Dubins flight"},
          .presets = {{.name = "default", .help = "It has no parameters."}},
          .parameters = ParamTable(std::vector<Parameter>{}),
          .refuses = refusal,
          .make = [](const ParamValues&) { return Planner(IntervalPlanner{}); }};
}

}  // namespace alate
