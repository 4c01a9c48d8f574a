// Ants on a 30 x 30 and a 100 x 100 grid: one step, ours against the textbook word for word in the same run; deposit,
// evaporation and tables; and how far the routes of every preset are from the shortest on 40 drawn maps.
//
// `speedup`: times as fast as literal. Processor time, so that a busy machine counts less.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "../tests/support/fly.hpp"
#include "../tests/support/grid_sites.hpp"
#include "aco/colony.hpp"
#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/none.hpp"
#include "aco/heuristic/goal_table.hpp"
#include "aco/heuristic/multi_factor.hpp"
#include "aco/local_search/none.hpp"
#include "aco/transition/move_table.hpp"
#include "aco/walk/grid_walk.hpp"
#include "literal_grid_ants.hpp"

namespace {

using namespace alate;

constexpr std::size_t kAnts = 50;
constexpr std::uint64_t kIterations = 40;
constexpr int kLiteralWalks = 200;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double literal_seconds(const HeightGrid& grid, bool factors) {
  bench::LiteralGridAnt ant(grid, {0, grid.rows - 1}, {grid.columns - 1, 0}, factors);
  std::mt19937_64 random(1);
  std::size_t steps = 0;
  const double start = cpu_s();
  for (int i = 0; i < kLiteralWalks; ++i) steps += ant.walk(random);
  return (cpu_s() - start) / static_cast<double>(steps);
}

/// Walks of a colony, everything written down that a deposit needs.
template <class Choice>
double our_seconds(const GridSpace& space, const Choice& choice) {
  using Policies = GridPolicies<Choice, NoDeposit, NoLocalSearch>;
  Policies policies{
      choice, Trail<MoveCells>(MoveCells(space.cells()), {.initial = 20, .unknown_decays = true}), {}, {}};
  GridWalk<Policies> walk(space, {.ants = kAnts});
  std::vector<Ant> ants(kAnts);
  for (std::size_t a = 0; a < kAnts; ++a) ants[a].index = a;
  Executor executor;
  RunContext run(executor, {});
  walk(policies, ants, Ant{}, run);  // allocates
  std::size_t steps = 0;
  const double start = cpu_s();
  while (run.start_iteration(kIterations)) {
    walk(policies, ants, Ant{}, run);
    for (const Ant& ant : ants) steps += ant.actions.size();
  }
  return (cpu_s() - start) / static_cast<double>(steps);
}

/// What both walk on; `factors`: the literal ants weigh moves by those of Yin et al. 2021.
struct Ground {
  const HeightGrid& grid;
  const GridSpace& space;
  bool factors;
};

template <class Choice>
void against_literal(benchmark::State& state, const Ground& ground, const Choice& choice) {
  double ours = 0;
  double literal = 0;
  for (auto _ : state) {
    const double pass = our_seconds(ground.space, choice);
    state.SetIterationTime(pass);
    ours += pass;
    literal += literal_seconds(ground.grid, ground.factors);
  }
  const auto passes = static_cast<double>(state.iterations());
  state.counters["ns_per_step"] = ours / passes * 1e9;
  state.counters["literal_ns"] = literal / passes * 1e9;
  state.counters["speedup"] = literal / ours;
}

void table_step(benchmark::State& state) {
  const HeightGrid grid = test::drawn_grid(static_cast<int>(state.range(0)), 2);
  const GridSpace space = test::corner_space(grid, std::numbers::sqrt2);
  against_literal(state, {grid, space, false}, MoveTable(goal_distance_table(space, 3), 1, 0));
}

void guided_step(benchmark::State& state) {
  const HeightGrid grid = test::drawn_grid(static_cast<int>(state.range(0)), 2);
  const GridSpace space = test::corner_space(grid, std::numbers::sqrt2);
  against_literal(state, {grid, space, false}, MoveTable(goal_directed_table(space, 0.4), 1, 0));
}

/// Ant Colony System: with chance 0.5 the heaviest move.
void heaviest_step(benchmark::State& state) {
  const HeightGrid grid = test::drawn_grid(static_cast<int>(state.range(0)), 2);
  const GridSpace space = test::corner_space(grid, std::numbers::sqrt2);
  against_literal(state, {grid, space, false}, MoveTable(goal_directed_table(space, 0.4), 1, 0.5));
}

void multi_factor_step(benchmark::State& state) {
  const HeightGrid grid = test::drawn_grid(static_cast<int>(state.range(0)), 2);
  const GridSpace space = test::corner_space(grid, 1.4);
  against_literal(state, {grid, space, true}, MultiFactor(space, {.mu_power = 1}));
}

/// What comes between walks: all trails evaporate, 50 ants deposit, tables are built again. Nanoseconds a move left, a
/// cell with trails.
void trails(benchmark::State& state) {
  const HeightGrid grid = test::drawn_grid(static_cast<int>(state.range(0)), 2);
  const GridSpace space = test::corner_space(grid, std::numbers::sqrt2);
  using Policies = GridPolicies<MoveTable, AntSystem, NoLocalSearch>;
  Policies policies{MoveTable(goal_distance_table(space, 3), 1, 0),
                    Trail<MoveCells>(MoveCells(space.cells()), {.evaporation = 0.1, .unknown_decays = true}),
                    {},
                    {}};
  GridWalk<Policies> walk(space, {.ants = 50, .step_backs = 1000000});
  std::vector<Ant> ants(50);
  for (std::size_t a = 0; a < ants.size(); ++a) ants[a].index = a;
  Executor executor;
  RunContext run(executor, {});
  walk(policies, ants, Ant{}, run);
  std::size_t moves = 0;
  for (const Ant& ant : ants) moves += ant.keys.size();
  constexpr int kRounds = 200;
  const auto seconds = [&](const auto& rebuild) {
    const double start = cpu_s();
    for (int i = 0; i < kRounds; ++i) {
      policies.trail.evaporate();
      policies.deposit(policies.trail, Harvest{ants, ants[0], ants[0], 1});
      rebuild();
    }
    return (cpu_s() - start) / kRounds;
  };
  double deposit = 0;
  double both = 0;
  for (auto _ : state) {
    deposit += seconds([] {});
    both += seconds([&] { policies.choice.prepare(policies.trail); });
  }
  const auto passes = static_cast<double>(state.iterations());
  const auto cells = static_cast<double>(policies.trail.store().known_cells().size());
  state.counters["deposit_ns_a_move"] = deposit / passes / static_cast<double>(moves) * 1e9;
  state.counters["deposit_us"] = deposit / passes * 1e6;
  state.counters["table_ns_a_cell"] = (both - deposit) / passes / cells * 1e9;
  state.counters["table_us"] = (both - deposit) / passes * 1e6;
}

/// Mean and worst gap to the shortest way over 40 maps with a way, in percent of those solved, after so many
/// microseconds of wall time (0: as many iterations as the preset has). li2019 and yin2021 judge by more than length.
void gaps(benchmark::State& state, const PlannerRequest& request) {
  constexpr int kMaps = 40;
  const auto side = static_cast<int>(state.range(0));
  const double limit_s = static_cast<double>(state.range(1)) * 1e-6;
  double sum = 0, worst = 0, used = 0;
  int solved = 0, maps = 0, shortest = 0;
  for (auto _ : state) {
    for (std::uint64_t seed = 1; maps < kMaps; ++seed) {
      const HeightGrid grid = test::drawn_grid(side, seed);
      const double least = test::shortest_length(test::corner_space(grid, std::numbers::sqrt2));
      if (!(least < kInfinity)) continue;
      ++maps;
      const World world(test::grid_site(grid));
      RunOptions options{.seed = seed};
      if (limit_s > 0) options.time_limit_s = limit_s;
      const double start = cpu_s();
      const Plan plan = test::fly(world, request, options);
      used += cpu_s() - start;
      if (plan.route.empty()) continue;
      ++solved;
      const double gap = plan.cost / least - 1;
      sum += gap;
      worst = std::max(worst, gap);
      shortest += gap < 1e-9 ? 1 : 0;
    }
  }
  state.counters["gap_percent"] = 100 * sum / solved;
  state.counters["worst_percent"] = 100 * worst;
  state.counters["shortest"] = shortest;
  state.counters["solved"] = solved;
  state.counters["cpu_ms"] = used / maps * 1e3;
}

}  // namespace

BENCHMARK(table_step)->Arg(30)->Arg(100)->UseManualTime()->Iterations(10);
BENCHMARK(guided_step)->Arg(30)->Arg(100)->UseManualTime()->Iterations(10);
BENCHMARK(heaviest_step)->Arg(30)->Arg(100)->UseManualTime()->Iterations(10);
BENCHMARK(multi_factor_step)->Arg(30)->Arg(100)->UseManualTime()->Iterations(10);
BENCHMARK(trails)->Arg(30)->Arg(100)->Iterations(10);
PlannerRequest colony(const std::string& preset, std::vector<ParamSetting> settings = {}) {
  return {.name = "grid-aco", .preset = preset, .settings = std::move(settings)};
}
#define ALATE_GAPS(name, request)        \
  BENCHMARK_CAPTURE(gaps, name, request) \
      ->Args({30, 6000})                 \
      ->Args({100, 12000})               \
      ->Args({30, 0})                    \
      ->Args({100, 0})                   \
      ->Iterations(1)                    \
      ->Unit(benchmark::kMillisecond)
ALATE_GAPS(improved, colony("improved"));
ALATE_GAPS(li2019, colony("li2019"));
ALATE_GAPS(yin2021, colony("yin2021"));
ALATE_GAPS(as, colony("as"));
ALATE_GAPS(acs, colony("acs"));
ALATE_GAPS(rank, colony("rank"));
ALATE_GAPS(mmas, colony("mmas"));
// What is left of `improved` without pheromone, without local search, and where all ants take the best move they see.
ALATE_GAPS(no_pheromone, colony("improved", {{"alpha", "0"}}));
ALATE_GAPS(no_sight, colony("improved", {{"local_search", "none"}}));
ALATE_GAPS(greedy, colony("improved", {{"alpha", "0"}, {"q0", "1"}, {"follow", "0"}}));
