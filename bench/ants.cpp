// One candidate of one ant with three threats: rotation, cost, trail and draw. Ours against the paper word for word, in
// the same run.
//
// `speedup`: times as fast as literal. Both walk from the start to the goal, or 40 steps, on layout C.
#include <benchmark/benchmark.h>

#include <ctime>

#include "../tests/support/hand_made_sites.hpp"
#include "aco/heuristic/goal_directed.hpp"
#include "aco/heuristic/power.hpp"
#include "aco/pheromone/grid_cells.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/roulette.hpp"
#include "alate/plan/registry.hpp"
#include "literal_ants.hpp"
#include "space/attitude_ants.hpp"

namespace {

using namespace alate;

constexpr std::size_t kMostSteps = 40;
// Passes long enough for the clock, and for what a colony pays once in thousands of walks: untouched pages of the grid.
constexpr std::uint64_t kOurWalks = 4000;
constexpr std::uint64_t kLiteralWalks = 200;

const World& layout_c() {
  static const World world(test::konatowski_site(0.5, test::kLayoutC));
  return world;
}

/// Processor time, so that a busy machine counts less.
template <class Walk>
double seconds_per_candidate(std::uint64_t walks, const Walk& walk) {
  std::size_t steps = 0;
  const std::clock_t start = std::clock();
  for (std::uint64_t ant = 0; ant < walks; ++ant) steps += walk(Stream(1, 1, ant));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return seconds / static_cast<double>(125 * steps);
}

double literal_seconds() {
  static bench::PointTrails trails;
  if (trails.empty())
    for (std::uint64_t i = 0; i < 20000; ++i) {
      Stream stream(2, 0, i);
      trails[{20 * stream.uniform(), 20 * stream.uniform(), 10 * stream.uniform()}] = 0.5;
    }
  bench::LiteralAnt ant(layout_c().site(), trails);
  return seconds_per_candidate(kLiteralWalks, [&](Stream stream) { return ant.walk(stream, kMostSteps); });
}

/// What Colony does for every ant, without the bookkeeping of its route.
template <class Heuristic, class Store>
void against_literal(benchmark::State& state, const Heuristic& heuristic, Store store) {
  const AttitudeSpace lattice(layout_c(), nullptr);
  const AttitudeAnts ants(layout_c(), lattice);
  Trail<Store> trail(std::move(store), {});
  Choices choices;
  const auto walk = [&](Stream stream) {
    AttitudeState at = ants.start();
    std::size_t steps = 0;
    while (steps < kMostSteps && !ants.is_goal(at)) {
      ants.look(at, choices);
      heuristic(choices, 0);
      trail.weigh(1, choices);
      at = ants.next(at, Roulette{}(choices, stream));
      ++steps;
    }
    return steps;
  };
  double ours = 0;
  double literal = 0;
  for (auto _ : state) {
    const double pass = seconds_per_candidate(kOurWalks, walk);
    state.SetIterationTime(pass);
    ours += pass;
    literal += literal_seconds();
  }
  const auto passes = static_cast<double>(state.iterations());
  state.counters["ns_per_candidate"] = ours / passes * 1e9;
  state.counters["literal_ns"] = literal / passes * 1e9;
  state.counters["speedup"] = literal / ours;
}

void guided_on_grid(benchmark::State& state) {
  const AttitudeSpace lattice(layout_c(), nullptr);
  const AttitudeAnts ants(layout_c(), lattice);
  against_literal(state, GoalDirected(0.06 * ants.step_price(), 1, 1), *GridCells::over(ants.reach(), 0.5F));
}

void published_on_grid(benchmark::State& state) {
  const AttitudeSpace lattice(layout_c(), nullptr);
  against_literal(state, PowerHeuristic{3}, *GridCells::over(AttitudeAnts(layout_c(), lattice).reach(), 0.5F));
}

void published_on_points(benchmark::State& state) { against_literal(state, PowerHeuristic{3}, HashCells(1e-4)); }

/// A large colony on 1, 2 and 4 threads; wall time.
void threads(benchmark::State& state) {
  const Problem problem(layout_c());
  const ChosenPlanner chosen = choose_planner(builtin_planners(), problem,
                                              {.name = "attitude-aco",
                                               .settings = {{"ants", "2000", "bench"},
                                                            {"local_search", "none", "bench"},
                                                            {"follow", "0", "bench"},
                                                            {"first_route", "none", "bench"}}});
  Executor executor(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    RunContext run(executor, {.iterations = 10});
    benchmark::DoNotOptimize(chosen.planner.plan(problem, run));
  }
}

}  // namespace

BENCHMARK(guided_on_grid)->UseManualTime()->Iterations(10);
BENCHMARK(published_on_grid)->UseManualTime()->Iterations(10);
BENCHMARK(published_on_points)->UseManualTime()->Iterations(10);
BENCHMARK(threads)->Arg(1)->Arg(2)->Arg(4)->UseRealTime()->Unit(benchmark::kMillisecond);
