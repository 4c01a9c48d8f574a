// Flights between places drawn at random over the ground of a world, planned by the interval search and checked.
#pragma once

#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <optional>
#include <string>

#include "alate/check/check.hpp"
#include "alate/core/stream.hpp"
#include "support/fly.hpp"

namespace alate::test {

inline Box2 ground_area(const Site& site) { return std::get<HeightRaster>(site.ground).area; }

/// A place in the band and outside every core; nothing if a few hundred draws find none.
inline std::optional<Vec3> draw_place(const World& world, Stream& random) {
  const Box2 area = ground_area(world.site());
  const Band& band = world.site().band;
  for (int draw = 0; draw < 300; ++draw) {
    const Vec2 size = area.max - area.min;
    const Vec2 place = area.min + Vec2(size.x() * random.uniform(), size.y() * random.uniform());
    const double part = random.uniform();
    const auto ground = world.height(place);
    if (!ground || std::isnan(*ground)) continue;
    const double floor = *ground + band.clearance_m;
    const double ceiling = std::min(*ground + *band.ceiling_agl_m, band.ceiling_amsl_m.value_or(1e9));
    Vec3 position(place.x(), place.y(), floor + part * (ceiling - floor));
    if (floor <= ceiling && world.is_free({position, position})) return position;
  }
  return std::nullopt;
}

/// Ends at least 0.3 of the ground's diagonal apart; every second flight has a heading at its start.
inline std::optional<Mission> draw_mission(const World& world, Stream random) {
  const Box2 area = ground_area(world.site());
  for (int draw = 0; draw < 100; ++draw) {
    const auto start = draw_place(world, random);
    const auto goal = draw_place(world, random);
    if (!start || !goal || (*goal - *start).head<2>().norm() < 0.3 * (area.max - area.min).norm()) continue;
    const double heading = 2 * kPi * random.uniform();
    return Mission{.start = *start,
                   .heading_rad = heading,
                   .heading_given = random.uniform() < 0.5,
                   .goal = *goal,
                   .tolerance_m = world.site().mission.tolerance_m};
  }
  return std::nullopt;
}

struct Answer {
  Outcome outcome = Outcome::none_found;
  Stop stop = Stop::finished;
  double cost = 0;
  double lower_bound = 0;
  double planner_s = 0;  ///< Processor time of the planner.
  std::string fault;     ///< Why the answer is wrong: an exception, a broken rule, a cost below the bound.

  bool solved() const { return outcome == Outcome::feasible || outcome == Outcome::optimal; }
};

/// What is wrong with a plan; empty if nothing is.
inline std::string fault_of(const Site& site, const Plan& plan) {
  const bool found = plan.outcome == Outcome::feasible || plan.outcome == Outcome::optimal;
  if (!found) return plan.route.empty() ? "" : "a route, but none is claimed";
  const Verdict verdict = check(site, plan.route);
  if (!verdict.violations.empty()) {
    const Violation& broken = verdict.violations.front();
    return fmt::format("{} on leg {}: {:.6f} of {:.6f} {}", broken.rule, broken.leg, broken.value, broken.limit,
                       broken.unit);
  }
  if (!verdict.ok()) return "the check cannot tell";
  const double cost = measure(site, plan.route).cost;
  if (!(std::abs(plan.cost - cost) <= 1e-6 * cost)) return fmt::format("costs {}, says {}", cost, plan.cost);
  if (plan.cost < plan.lower_bound * (1 - 1e-9)) return fmt::format("{} below bound {}", plan.cost, plan.lower_bound);
  return "";
}

/// Processor time of this thread, so that a busy machine counts less.
inline double thread_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One flight on one thread. Exceptions are faults.
inline Answer fly_query(const Site& site, const Mission& mission, const RunOptions& options) {
  Site asked = site;
  asked.mission = mission;
  const World world(std::move(asked));
  Answer answer;
  try {
    const double before = thread_s();
    const Plan plan = fly(world, {.name = "interval-astar"}, options);
    const double planner_s = thread_s() - before;
    answer = {.outcome = plan.outcome,
              .stop = plan.stop,
              .cost = plan.cost,
              .lower_bound = plan.lower_bound,
              .planner_s = planner_s,
              .fault = fault_of(world.site(), plan)};
  } catch (const std::exception& error) {
    answer.fault = error.what();
  }
  return answer;
}

/// The command that asks the same.
inline std::string command_for(const Site& site, const Mission& mission, const std::string& file) {
  const auto place = [](const Vec3& p) { return fmt::format("position_m: [{}, {}, {}]", p.x(), p.y(), p.z()); };
  const std::string heading =
      mission.heading_given ? fmt::format(", heading_deg: {}", degrees(mission.heading_rad)) : "";
  const std::string frame = site.frame.is_local() ? "{local: true}" : fmt::format("{{crs: \"{}\"}}", site.frame.name());
  return fmt::format(
      "alate plan {} --planner interval-astar --override 'terrain.dem={}' --override 'frame={}' "
      "--override 'start={{{}{}}}' --override 'goal={{{}, tolerance_m: {}}}'",
      file, site.scenario.terrain->dem, frame, place(mission.start), heading, place(mission.goal), mission.tolerance_m);
}

}  // namespace alate::test
