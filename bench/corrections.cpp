// Routes over correction points: label-setting against boost::r_c_shortest_paths on the same sets in the same run, and
// how it grows with the number of points.
//
// Fronts of both must agree. `speedup`: times as fast as Boost; its graph is built beforehand and not counted, ours is.
// Set 1 of the contest is read from the shared data, where they are there; the rest is drawn by its law.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "../tests/support/boost_front.hpp"
#include "../tests/support/correction_sites.hpp"
#include "alate/plan/registry.hpp"
#include "search/label_setting/chance_front.hpp"

namespace {

using namespace alate;

constexpr std::uint64_t kSeed = 1;

/// 0: the contest's set 1.
CorrectionField field_of(std::int64_t points) {
  if (points == 0) return test::never_failing(test::contest_field(CorrectionLaw::set1));
  return test::never_failing(draw_corrections(CorrectionLaw::set1, static_cast<int>(points), kSeed));
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

FrontResult our_front(const CorrectionGraph& graph) {
  Executor executor(1);
  RunContext run(executor, {});
  return correction_front(graph, run);
}

bool agree(const FrontResult& ours, const std::vector<test::FrontValue>& theirs) {
  return std::ranges::equal(ours.routes, theirs, [](const CorrectionRoute& a, const test::FrontValue& b) {
    return static_cast<int>(a.points.size()) == b.corrections && std::abs(a.length_m - b.length_m) < 1e-6;
  });
}

void front_against_boost(benchmark::State& state) {
  if (state.range(0) == 0 && !std::filesystem::exists(test::shared_data("correction-points/set1.csv"))) {
    state.SkipWithError("SKIPPED: needs the contest's set 1 in the shared data");
    return;
  }
  const CorrectionField field = field_of(state.range(0));
  const test::BoostFront boost(field);
  const double before = seconds();
  const auto theirs = boost.solve();
  const double boost_s = seconds() - before;
  const CorrectionGraph graph(field.navigation, field.start, field.goal);
  FrontResult ours;
  const double start = seconds();
  for (auto _ : state) benchmark::DoNotOptimize(ours = our_front(graph));
  const double ours_s = (seconds() - start) / static_cast<double>(state.iterations());
  if (!agree(ours, theirs)) state.SkipWithError("the fronts differ");
  state.counters["boost_s"] = boost_s;
  state.counters["routes"] = static_cast<double>(theirs.size());
  state.counters["speedup"] = boost_s / ours_s;
}

/// Straight from points to plan, as the program does.
void plan(benchmark::State& state, bool front) {
  const World world(test::correction_site(field_of(state.range(0))));
  Problem problem(world);
  problem.front = front;
  const ChosenPlanner chosen = choose_planner(builtin_planners(), problem, {.name = "label-setting"});
  Plan found;
  for (auto _ : state) {
    Executor executor(1);
    RunContext run(executor, {});
    found = chosen.planner.plan(problem, run);
  }
  if (found.outcome != Outcome::optimal) state.SkipWithError("not proven");
  state.counters["labels"] = static_cast<double>(found.counters["labels"]);
  state.counters["routes"] = static_cast<double>(found.front.size());
}

void shortest(benchmark::State& state) { plan(state, false); }
void whole_front(benchmark::State& state) { plan(state, true); }

BENCHMARK(front_against_boost)->Arg(0)->Arg(1'000)->Arg(10'000)->Unit(benchmark::kMillisecond);
BENCHMARK(shortest)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_front)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
