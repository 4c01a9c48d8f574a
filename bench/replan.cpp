// Replanning in flight over Jacksboro, 26 km: how long until a first route that passes the check, in a session that has
// planned the flight before, and beside it from nothing (the planner `interval-astar` with one iteration). Threats pop
// up ahead, the goal moves, the ceiling drops, each at a random time; or the aircraft is anywhere else, so that nothing
// of the old route serves. Processor time of one core, so that a busy machine counts less. A threat that leaves the old
// rest as it is (as most ceilings do) is a replan like any other.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "alate/alate.hpp"
#include "alate/core/stream.hpp"
#include "alate/plan/session.hpp"

namespace {

using namespace alate;

constexpr int kCases = 200;
constexpr std::uint64_t kIterations = 20;  ///< Spent on the route that is replanned.

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

enum class Kind { threat, goal, ceiling, elsewhere };

struct Case {
  FlightState state;
  FlightChange change;
};

Plan plan_with(Session& session, std::uint64_t iterations) {
  Executor executor(1);
  RunContext run(executor, {.iterations = iterations});
  return session.plan(run);
}

Site jacksboro() { return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml")); }

const Route& old_route() {
  static const Route kRoute = [] {
    Session session(jacksboro());
    return plan_with(session, kIterations).route;
  }();
  return kRoute;
}

/// A site that may be asked of a planner: its ends keep all limits, with room to turn round cores.
bool is_fair(const Site& site) {
  const double room = 4 * *site.vehicle.turn_radius_m;
  const World world(site);
  const auto fits = [&](const Vec3& place) {
    const auto clear = [&](const Threat& threat) {
      return (place - threat.center).head<2>().norm() > threat.core_m + room;
    };
    return world.is_free({place, place}) && std::ranges::all_of(site.threats, clear);
  };
  return fits(site.mission.start) && fits(site.mission.goal);
}

Site changed(Site site, const Case& drawn) {
  site.mission.start = drawn.state.position;
  site.mission.heading_rad = drawn.state.heading_rad;
  site.mission.heading_given = true;
  if (drawn.change.threats) site.threats = *drawn.change.threats;
  if (drawn.change.goal) site.mission.goal = *drawn.change.goal;
  if (drawn.change.band) site.band = *drawn.change.band;
  return site;
}

/// Anywhere over the ground, in the band, in any direction.
FlightState draw_state(const Site& site, Stream& random) {
  const Box2& area = std::get<HeightRaster>(site.ground).area;
  const Vec2 size = area.max - area.min;
  const Vec2 place = area.min + Vec2(size.x() * random.uniform(), size.y() * random.uniform());
  return {.position = {place.x(), place.y(), site.ground_height(place).value_or(0) + 120},
          .heading_rad = 2 * kPi * random.uniform()};
}

FlightChange draw_change(const Site& site, Kind kind, double flown_m, Stream& random) {
  if (kind == Kind::elsewhere) return {};
  const auto around = [&](const Vec2& middle, double most_m) {
    const double angle = 2 * kPi * random.uniform();
    return Vec2(middle + most_m * random.uniform() * Vec2(std::cos(angle), std::sin(angle)));
  };
  const auto at = [&](const Vec2& xy, double above) {
    return Vec3(xy.x(), xy.y(), site.ground_height(xy).value_or(0) + above);
  };
  if (kind == Kind::ceiling) {
    Band band = site.band;
    band.ceiling_agl_m = 130 + 60 * random.uniform();
    return {.band = band};
  }
  if (kind == Kind::goal) return {.goal = at(around(site.mission.goal.head<2>(), 5000), 120)};
  const auto ahead = state_along(old_route(), flown_m + 1500 + 6000 * random.uniform());
  std::vector<Threat> threats = site.threats;
  const Vec2 middle = ahead ? Vec2(ahead->position.head<2>()) : Vec2(site.mission.goal.head<2>());
  const double core = 300 + 900 * random.uniform();
  threats.push_back({.name = "pop-up",
                     .center = at(around(middle, 800), 0),
                     .radius_m = core * (1 + 1.5 * random.uniform()),
                     .level = 0.8,
                     .core_m = core});
  return {.threats = threats};
}

std::vector<Case> draw_cases(Kind kind) {
  const Site site = jacksboro();
  const double length = flown_length(old_route());
  Stream random(1, static_cast<std::uint64_t>(kind), 0);
  std::vector<Case> cases;
  while (cases.size() < kCases) {
    const double flown_m = (0.02 + 0.8 * random.uniform()) * length;
    Case drawn{.state = *state_along(old_route(), flown_m), .change = draw_change(site, kind, flown_m, random)};
    if (kind == Kind::elsewhere) drawn.state = draw_state(site, random);
    if (is_fair(changed(site, drawn))) cases.push_back(std::move(drawn));
  }
  return cases;
}

struct Timed {
  double seconds = 0;
  bool passes = false;
  bool proven = false;  ///< That there is no route.
  double cost = 0;
};

Timed replan(const Case& drawn) {
  Session session(jacksboro());
  plan_with(session, 1);
  session.follow(old_route());
  Executor executor(1);
  RunContext run(executor, {.iterations = 1});
  const double start = cpu_s();
  const Plan plan = session.replan(drawn.state, drawn.change, run);
  const bool passes = !plan.route.empty() && check(session.site(), plan.route).ok();
  return {.seconds = cpu_s() - start,
          .passes = passes,
          .proven = plan.outcome == Outcome::infeasible_proven,
          .cost = plan.cost};
}

Timed plan_cold(const Case& drawn) {
  const Site site = changed(jacksboro(), drawn);
  Executor executor(1);
  RunContext run(executor, {.iterations = 1});
  const double start = cpu_s();
  const World world(site);
  const ChosenPlanner chosen = choose_planner(builtin_planners(), Problem(world), {.name = "interval-astar"});
  const Plan plan = chosen.planner.plan(Problem(world), run);
  const bool passes = !plan.route.empty() && check(site, plan.route).ok();
  return {.seconds = cpu_s() - start,
          .passes = passes,
          .proven = plan.outcome == Outcome::infeasible_proven,
          .cost = plan.cost};
}

template <class Run>
void measure_all(benchmark::State& state, const Run& run) {
  const std::vector<Case> cases = draw_cases(static_cast<Kind>(state.range(0)));
  std::vector<double> ms;
  double cost = 0;
  int proven = 0;
  for (auto _ : state) {
    for (const Case& drawn : cases) {
      const Timed timed = run(drawn);
      proven += timed.proven ? 1 : 0;
      if (!timed.passes) continue;
      ms.push_back(1e3 * timed.seconds);
      cost += timed.cost;
    }
  }
  if (ms.empty()) return;
  std::ranges::sort(ms);
  const auto rank = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  state.counters["median_ms"] = rank(0.5);
  state.counters["p99_ms"] = rank(0.99);
  state.counters["most_ms"] = ms.back();
  state.counters["found_percent"] = 100.0 * static_cast<double>(ms.size()) / static_cast<double>(cases.size());
  state.counters["proven"] = proven;
  state.counters["cost"] = cost / static_cast<double>(ms.size());
}

void warm(benchmark::State& state) { measure_all(state, replan); }
void cold(benchmark::State& state) { measure_all(state, plan_cold); }

/// 0: a threat ahead, 1: another goal, 2: a lower ceiling, 3: the aircraft is elsewhere.
BENCHMARK(warm)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(cold)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
