#include "plan/flight/flight_bound.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "plan/place_name.hpp"
#include "search/interval/any_angle_bound.hpp"
#include "space/bound/bottleneck.hpp"
#include "space/bound/first_turn.hpp"

namespace alate {

namespace {

/// Why no flight exists, if `voids` are as assumed; empty where that is not proven.
std::string barrier(const Problem& problem, const Bottleneck& bound, Voids voids) {
  const Site& site = problem.world.site();
  const Vec3& start = problem.mission.start;
  if (bound.at_start)
    return fmt::format("the start ({}, {:.0f} m above sea level) is not open between ground, ceiling and cores",
                       place_name(site, start.head<2>()), start.z());
  if (const auto dead = dead_ahead(problem, voids))
    return fmt::format(
        "the start heads into something closer than a turn: however it turns, nothing is open {:.0f} m "
        "ahead, at {}",
        dead->ahead_m, place_name(site, dead->where));
  if (!bound.barred) return {};
  const Vec2 goal = problem.mission.goal.head<2>();
  if (bound.at_goal)
    return fmt::format("within {} m of the goal ({}) no altitude is open between ground, ceiling and cores",
                       problem.mission.tolerance_m, place_name(site, goal));
  return fmt::format(
      "ground, ceiling and cores part the start from the goal, whatever the aircraft: what can be "
      "reached ends at {}, {:.0f} m from the goal",
      place_name(site, bound.nearest), (bound.nearest - goal).norm());
}

/// Why the range does not suffice; empty where that is not proven.
std::string beyond_range(const Problem& problem, const BottleneckOptions& options, RunContext& run) {
  const auto& range_m = problem.vehicle.range_m;
  if (!range_m) return {};
  const ObjectiveSpec length_alone{.model = CostModel::physical, .length = 1, .threat = 0, .climb = 0};
  const double least_m = bottleneck(Problem(problem.world, problem.mission, length_alone), options, run).cost;
  if (least_m <= *range_m) return {};
  return fmt::format("no route is shorter than {:.0f} m, and vehicle.range_m is {:.0f}", least_m, *range_m);
}

/// A proof is worth a finer look than a bound, once nothing was found: thin walls fall between the sides of large
/// cells.
constexpr double kProofCells = 400'000;
/// For a first look, of about a millisecond.
constexpr double kFirstCells = 4'000;

/// Where no flight can exist says so in the plan.
void note_barrier(const Problem& problem, double most_cells, RunContext& run, Plan& plan) {
  const auto look = [&](Voids voids) {
    const BottleneckOptions options{.voids = voids, .most_cells = most_cells};
    const std::string barred = barrier(problem, bottleneck(problem, options, run), voids);
    return barred.empty() ? beyond_range(problem, options, run) : barred;
  };
  const std::string seen = look(Voids::closed);
  if (seen.empty()) return;
  const auto* raster = std::get_if<HeightRaster>(&problem.world.site().ground);
  const bool has_voids = raster != nullptr && raster->voids > 0;
  plan.why = has_voids ? look(Voids::open) : seen;
  if (!plan.why.empty())
    plan.outcome = Outcome::infeasible_proven;
  else
    plan.why = seen + "; ground without data counts as closed, so nothing is proven about the way across it";
}

}  // namespace

void note_barrier(const Problem& problem, RunContext& run, Plan& plan) {
  if (problem.world.site().has_ground()) note_barrier(problem, kFirstCells, run, plan);
}

void note_bound(const Problem& problem, BoundEffort effort, RunContext& run, Plan& plan) {
  if (!problem.world.site().has_ground()) return;
  plan.lower_bound = std::max(plan.lower_bound, bottleneck(problem, {}, run).cost);
  if (effort == BoundEffort::tight && !plan.route.empty())
    plan.lower_bound = any_angle_bound(problem, {.least = plan.lower_bound, .most = plan.cost}, run);
  if (plan.route.empty() && run.keep_going()) note_barrier(problem, kProofCells, run, plan);
}

}  // namespace alate
