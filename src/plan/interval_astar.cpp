// The flagship: a fixed wing over real ground, by true Dubins pieces and intervals of altitude.
#include <algorithm>
#include <bit>
#include <cmath>

#include "plan/flight_planners.hpp"
#include "search/interval/flight_path.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/lower_bound.hpp"

namespace alate {

namespace {

struct IntervalPlanner {
  /// Weight of the cost-to-go and width of bins, in their usual width: one search each, the hasty ones first.
  struct Pass {
    double epsilon;
    double bin;
  };
  static constexpr std::array kPasses{Pass{2.5, 1},    Pass{1.15, 1},  Pass{1.05, 1}, Pass{1.15, 0.5},
                                      Pass{1.05, 0.5}, Pass{1.15, 2.0}, Pass{1.05, 2.0}};
  static constexpr std::uint64_t kIterations = 60;  ///< Where neither a budget nor a time limit is given.
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

  Plan plan(const Problem& problem, RunContext& run) const {
    const Mission& mission = problem.mission;
    Plan plan{.lower_bound = physical_bound(problem.world.site(), mission.start), .seed = run.seed()};
    const BandWalk band(problem.world);
    const FlightCost cost(band);
    const CostToGo to_go(problem.world, run);
    IntervalAStar search(cost, to_go);
    const FlightEnd end{.goal = mission.goal, .tolerance_m = std::max(0.0, mission.tolerance_m - 1e-3)};
    const double distance = (mission.goal - mission.start).norm();
    const double bin = std::clamp(distance / 250, band.radius_m() / 2, 4 * band.radius_m());
    std::vector<FlightPath> paths;
    Stream random(run.seed(), 0, 0);
    std::size_t passes = 0;
    for (std::uint64_t round = 1; run.start_iteration(kIterations);) {
      if (passes < kPasses.size()) {
        const Pass pass = kPasses[passes++];
        const auto track = search.find(starts(mission), mission.start.z(), end,
                                       {.epsilon = pass.epsilon, .bin_m = bin * pass.bin}, run);
        plan.counters["expansions"] += search.expansions();
        if (track) {
          paths.emplace_back(cost, end, *track, mission.start.z());
          paths.back().shorten(run);
          paths.back().better(random, kTrials, run);
        }
      } else if (paths.empty()) {
        break;
      } else {
        // The best one every other round, the second one every fourth, ...
        const auto rank = static_cast<std::size_t>(std::countr_zero(round++));
        paths[std::min(rank, paths.size() - 1)].better(random, kTrials, run);
      }
      std::ranges::stable_sort(paths, std::less{}, &FlightPath::cost);
      if (!paths.empty()) run.report(paths.front().cost());
    }
    for (const FlightPath& path : paths) {
      const auto route = fly_track(band, path.track(), mission.start, path.end());
      if (!route) continue;
      plan.outcome = Outcome::feasible;
      plan.route = *route;
      plan.cost = path.cost();
      break;
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
