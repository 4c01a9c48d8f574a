// Ants on the lattice over the simple terrain of Mai et al. 2023, 51 x 51 nodes wide: one step, ours against the
// textbook word for word in the same run; deposit, evaporation and tables; the lattice itself; and what each preset
// finds on the example scenes.
//
// `ns_per_step`: choice, tabu, random number and path; `judged_ns`: that and the sum of what the route costs, which is
// what `speedup`, times as fast as literal, is of. Processor time, so that a busy machine counts less.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "../tests/support/fly.hpp"
#include "../tests/support/terrain_sites.hpp"
#include "aco/colony.hpp"
#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/dual_strategy.hpp"
#include "aco/deposit/none.hpp"
#include "aco/heuristic/terrain_factors.hpp"
#include "aco/local_search/none.hpp"
#include "aco/transition/lattice_table.hpp"
#include "aco/walk/lattice_walk.hpp"
#include "alate/data/scenario_file.hpp"
#include "literal_terrain_ants.hpp"

namespace {

using namespace alate;

constexpr std::size_t kAnts = 3200;
constexpr int kLiteralWalks = 100;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A lattice as the preset mai2023 lays it.
struct Ground {
  World world{test::simple_site()};
  Executor executor;
  RunContext run{executor, {}};
  TerrainLattice lattice{
      world,
      LatticeFrame(world, {}),
      {.steps = {},
       .rules = {.limits = {.pitch_rad = radians(45), .turn_rad = radians(60)}, .safe_agl_m = 100, .any_join = true},
       .score = {.rule = TerrainScore::Rule::paper}},
      run};
};

double literal_seconds() {
  static const Site kSite = test::simple_site();
  bench::LiteralTerrainAnt ant(std::get<PeakGround>(kSite.ground));
  std::mt19937_64 random(1);
  std::size_t steps = 0;
  const double start = cpu_s();
  for (int i = 0; i < kLiteralWalks; ++i) steps += ant.walk(random);
  return (cpu_s() - start) / static_cast<double>(steps);
}

template <class Deposit>
LatticePolicies<LatticeTable, Deposit, NoLocalSearch> policies_on(const Ground& ground, double q0) {
  return {LatticeTable(ground.lattice, terrain_factor_table(ground.lattice, {.beta = 2}), {.q0 = {.initial = q0}}),
          Trail<LatticeCells>(LatticeCells(ground.lattice.frame(), LatticeCells::On::edges),
                              {.evaporation = 0.2, .unknown_decays = true}),
          {},
          {}};
}

std::vector<Ant> ants_of(std::size_t count) {
  std::vector<Ant> ants(count);
  for (std::size_t a = 0; a < count; ++a) ants[a].index = a;
  return ants;
}

std::size_t moves_of(const std::vector<Ant>& ants) {
  std::size_t moves = 0;
  for (const Ant& ant : ants) moves += ant.actions.size();
  return moves;
}

/// Seconds a move.
struct WalkTimes {
  double all = 0;      ///< Of a walk, everything written down that a deposit needs, and judged.
  double judging = 0;  ///< Its part that adds up what the route costs.
};

double judging_seconds(const TerrainLattice& lattice, const std::vector<Ant>& ants) {
  std::vector<std::vector<TerrainLattice::Edge>> walks;
  for (const Ant& ant : ants) walks.emplace_back(ant.keys.begin(), ant.keys.end());
  const double start = cpu_s();
  for (const auto& walk : walks) benchmark::DoNotOptimize(lattice.judge(walk));
  return cpu_s() - start;
}

/// One large colony.
WalkTimes our_seconds(Ground& ground, double q0) {
  auto policies = policies_on<NoDeposit>(ground, q0);
  LatticeWalk<decltype(policies)> walk(ground.lattice, {.ants = kAnts});
  std::vector<Ant> ants = ants_of(kAnts);
  walk(policies, ants, Ant{}, ground.run);  // allocates
  const double start = cpu_s();
  walk(policies, ants, Ant{}, ground.run);
  const double seconds = cpu_s() - start;
  const auto moves = static_cast<double>(moves_of(ants));
  return {.all = seconds / moves, .judging = judging_seconds(ground.lattice, ants) / moves};
}

/// The argument is q0 in percent.
void step(benchmark::State& state) {
  Ground ground;
  double ours = 0;
  double judging = 0;
  double literal = 0;
  for (auto _ : state) {
    const WalkTimes pass = our_seconds(ground, static_cast<double>(state.range(0)) / 100);
    state.SetIterationTime(pass.all);
    ours += pass.all;
    judging += pass.judging;
    literal += literal_seconds();
  }
  const auto passes = static_cast<double>(state.iterations());
  state.counters["judged_ns"] = ours / passes * 1e9;
  state.counters["ns_per_step"] = (ours - judging) / passes * 1e9;
  state.counters["literal_ns"] = literal / passes * 1e9;
  state.counters["speedup"] = literal / ours;
}

/// What comes between walks of 30 ants. Nanoseconds a move left, a row of the table.
template <class Deposit>
void trails(benchmark::State& state) {
  Ground ground;
  auto policies = policies_on<Deposit>(ground, 0);
  LatticeWalk<decltype(policies)> walk(ground.lattice, {.ants = 30});
  std::vector<Ant> ants = ants_of(30);
  walk(policies, ants, Ant{}, ground.run);
  const Ant& best = *std::ranges::min_element(ants, {}, &Ant::cost);
  std::size_t moves = 0;
  policies.deposit(policies.trail, Harvest{ants, best, best, 1});
  const std::size_t rows = policies.trail.store().changed_rows().size();
  for (const Ant& ant : ants) moves += ant.arrived() ? ant.keys.size() : 0;
  if constexpr (std::is_same_v<Deposit, DualStrategy>) moves = best.keys.size();
  double deposit = 0;
  double evaporation = 0;
  double both = 0;
  constexpr int kRounds = 500;
  const auto seconds = [](const auto& body) {
    const double start = cpu_s();
    for (int i = 0; i < kRounds; ++i) body();
    return cpu_s() - start;
  };
  const auto leave = [&] { policies.deposit(policies.trail, Harvest{ants, best, best, 1}); };
  for (auto _ : state) {
    deposit += seconds(leave);
    evaporation += seconds([&] { policies.trail.evaporate(); });
    both += seconds([&] {
      leave();
      policies.choice.prepare(policies.trail, 1, 500);
    });
  }
  const double tables = both - deposit;
  const double rounds = kRounds * static_cast<double>(state.iterations());
  state.counters["deposit_ns_a_move"] = deposit / rounds / static_cast<double>(moves) * 1e9;
  state.counters["evaporation_ns"] = evaporation / rounds * 1e9;
  state.counters["table_ns_a_row"] = tables / rounds / static_cast<double>(rows) * 1e9;
  state.counters["table_us"] = tables / rounds * 1e6;
}

/// All free moves of the lattice, every leg looked at from end to end.
void lattice(benchmark::State& state) {
  std::size_t nodes = 0;
  for (auto _ : state) {
    const Ground ground;
    nodes = ground.lattice.frame().nodes();
  }
  state.counters["nodes"] = static_cast<double>(nodes);
}

/// Cost by the scenario's objective against the straight line, mean and worst of ten seeds, and milliseconds of
/// processor time. The argument is the limit of wall time in ms; 0: as many iterations as the preset has.
void scene(benchmark::State& state, const std::string& name, const std::string& preset) {
  constexpr std::uint64_t kSeeds = 10;
  const World world(load_site(load_scenario(ALATE_SOURCE_DIR "/examples/" + name + ".yaml")));
  double sum = 0, worst = 0, used = 0;
  for (auto _ : state) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      RunOptions options{.seed = seed};
      if (state.range(0) > 0) options.time_limit_s = static_cast<double>(state.range(0)) * 1e-3;
      const double start = cpu_s();
      const Plan plan = test::fly(world, {.name = "terrain-aco", .preset = preset}, options);
      used += cpu_s() - start;
      const double gap = plan.route.empty() ? 1 : plan.cost / plan.lower_bound - 1;
      sum += gap;
      worst = std::max(worst, gap);
    }
  }
  state.counters["gap_percent"] = 100 * sum / kSeeds;
  state.counters["worst_percent"] = 100 * worst;
  state.counters["cpu_ms"] = used / kSeeds * 1e3;
}

}  // namespace

BENCHMARK(step)->Arg(0)->Arg(50)->Arg(90)->UseManualTime()->Iterations(10);
BENCHMARK(trails<DualStrategy>)->Iterations(10);
BENCHMARK(trails<AntSystem>)->Iterations(10);
BENCHMARK(lattice)->Unit(benchmark::kMillisecond);
#define ALATE_SCENE(file, preset)                                      \
  BENCHMARK_CAPTURE(scene, file##_##preset, "mai2023/" #file, #preset) \
      ->Arg(0)                                                         \
      ->Iterations(1)                                                  \
      ->Unit(benchmark::kMillisecond)
#define ALATE_SCENES(preset)   \
  ALATE_SCENE(simple, preset); \
  ALATE_SCENE(medium, preset); \
  ALATE_SCENE(ours, preset)
ALATE_SCENES(improved);
ALATE_SCENES(mai2023);
ALATE_SCENES(aco);
