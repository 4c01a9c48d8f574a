// Exact search on benchmark maps: the 300 longest tasks of each, ours against the textbook's A* in the same run, and
// jump point search against our A*; ways at any angle against our A* on all tasks; then time and memory against the
// size of drawn maps.
//
// `speedup`: times as fast. Processor time, so that a busy machine counts less.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <queue>

#include "../tests/support/grid_sites.hpp"
#include "../tests/support/shared_data.hpp"
#include "data/scen_file.hpp"
#include "search/grid/anya.hpp"
#include "search/grid/astar.hpp"
#include "search/grid/directions.hpp"
#include "search/grid/jps.hpp"

namespace {

using namespace alate;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Task {
  GridPlace start;
  GridPlace goal;
};

/// A* word for word: a priority queue, lengths and closed cells in arrays that each query makes anew.
double literal_astar(const HeightGrid& grid, const Task& task) {
  using Entry = std::pair<double, std::size_t>;
  const auto column = [&](std::size_t cell) { return static_cast<int>(cell % static_cast<std::size_t>(grid.columns)); };
  const auto row = [&](std::size_t cell) { return static_cast<int>(cell / static_cast<std::size_t>(grid.columns)); };
  const auto is_free = [&](int x, int y) { return grid.contains(x, y) && !grid.blocked_at(x, y); };
  const std::size_t start = grid.index(task.start.column - 1, task.start.row - 1);
  const std::size_t goal = grid.index(task.goal.column - 1, task.goal.row - 1);
  const auto rest = [&](std::size_t cell) {
    const int across = std::abs(column(cell) - column(goal));
    const int along = std::abs(row(cell) - row(goal));
    return std::max(across, along) + (std::numbers::sqrt2 - 1) * std::min(across, along);
  };
  std::vector<double> lengths(grid.blocked.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> closed(grid.blocked.size());
  std::vector<std::size_t> parents(grid.blocked.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  lengths[start] = 0;
  open.emplace(rest(start), start);
  while (!open.empty()) {
    const std::size_t cell = open.top().second;
    open.pop();
    if (closed[cell]) continue;
    if (cell == goal) return lengths[goal];
    closed[cell] = true;
    for (unsigned d = 0; d < BitGrid::kDirections; ++d) {
      const auto [dx, dy] = kGridShifts[d];
      const int x = column(cell) + dx;
      const int y = row(cell) + dy;
      if (!is_free(x, y) || !is_free(column(cell), y) || !is_free(x, row(cell))) continue;
      const std::size_t next = grid.index(x, y);
      const double length = lengths[cell] + (d % 2 == 0 ? 1 : std::numbers::sqrt2);
      if (!(length < lengths[next])) continue;
      lengths[next] = length;
      parents[next] = cell;
      open.emplace(length + rest(next), next);
    }
  }
  return lengths[goal];
}

double length_of(const GridWay& way) { return way.length.value(); }
double length_of(const AnyAngleWay& way) { return way.length; }

template <class Search>
double seconds(Search& search, const std::vector<Task>& tasks, double& length) {
  Executor executor(1);
  RunContext run(executor, {});
  const double start = cpu_s();
  for (const Task& task : tasks) length += length_of(search.find(task.start, task.goal, run));
  return cpu_s() - start;
}

double literal_seconds(const HeightGrid& grid, const std::vector<Task>& tasks, double& length) {
  const double start = cpu_s();
  for (const Task& task : tasks) length += literal_astar(grid, task);
  return cpu_s() - start;
}

/// One pass over the tasks by each of the three.
void compare(benchmark::State& state, const HeightGrid& grid, const std::vector<Task>& tasks) {
  const BitGrid cells(grid);
  GridAStar astar(cells);
  JumpPointSearch jps(cells);
  double literal_s = 0, astar_s = 0, jps_s = 0;
  double literal_length = 0, astar_length = 0, jps_length = 0;
  for (auto _ : state) {
    literal_s += literal_seconds(grid, tasks, literal_length);
    astar_s += seconds(astar, tasks, astar_length);
    jps_s += seconds(jps, tasks, jps_length);
  }
  if (std::abs(literal_length - astar_length) > 1e-6 * literal_length || astar_length != jps_length)
    state.SkipWithError("lengths differ");
  const double queries = static_cast<double>(tasks.size()) * static_cast<double>(state.iterations());
  state.counters["literal_ms"] = literal_s / queries * 1e3;
  state.counters["astar_ms"] = astar_s / queries * 1e3;
  state.counters["jps_ms"] = jps_s / queries * 1e3;
  state.counters["astar_speedup"] = literal_s / astar_s;
  state.counters["jps_over_astar"] = astar_s / jps_s;
}

/// One pass over the tasks by A* and at any angle.
void compare_any_angle(benchmark::State& state, const HeightGrid& grid, const std::vector<Task>& tasks) {
  const BitGrid cells(grid);
  GridAStar astar(cells);
  Anya anya(cells);
  double astar_s = 0, anya_s = 0;
  double astar_length = 0, anya_length = 0;
  for (auto _ : state) {
    astar_s += seconds(astar, tasks, astar_length);
    anya_s += seconds(anya, tasks, anya_length);
  }
  if (!(anya_length < astar_length)) state.SkipWithError("not shorter");
  const double queries = static_cast<double>(tasks.size()) * static_cast<double>(state.iterations());
  state.counters["astar_ms"] = astar_s / queries * 1e3;
  state.counters["anya_ms"] = anya_s / queries * 1e3;
  state.counters["anya_over_astar"] = astar_s / anya_s;
  state.counters["shorter_percent"] = 100 * (1 - anya_length / astar_length);
}

/// By their length, longest first.
std::optional<ScenFile> read_tasks(const std::string& name, std::vector<Task>& tasks) {
  std::vector<Fault> faults;
  auto scen = read_scen_file(test::shared_data("movingai/2d/" + name + ".map.scen").string(), faults);
  if (!scen) return scen;
  std::ranges::stable_sort(scen->rows, std::ranges::greater{}, &ScenRow::optimum);
  for (const ScenRow& row : scen->rows)
    tasks.push_back({BitGrid::place(row.start_column, row.start_row), BitGrid::place(row.goal_column, row.goal_row)});
  return scen;
}

void longest_tasks(benchmark::State& state, const std::string& name) {
  constexpr std::size_t kRows = 300;
  std::vector<Task> tasks;
  const auto scen = read_tasks(name, tasks);
  if (!scen) return state.SkipWithError("needs the shared data");
  tasks.resize(std::min(tasks.size(), kRows));
  compare(state, scen->grid, tasks);
}

/// 0 rows: all of them.
void any_angle(benchmark::State& state, const std::string& name, std::size_t rows) {
  std::vector<Task> tasks;
  const auto scen = read_tasks(name, tasks);
  if (!scen) return state.SkipWithError("needs the shared data");
  if (rows > 0) tasks.resize(std::min(tasks.size(), rows));
  compare_any_angle(state, scen->grid, tasks);
}

/// A tenth of the cells blocked at random; the first draw with a way between the corners.
HeightGrid draw_map(int side, const Task& corners) {
  Executor executor(1);
  RunContext run(executor, {});
  for (int seed = 1;; ++seed) {
    HeightGrid grid = draw_grid({.size = {side, side}, .obstacles = 0.1, .seed = seed}, std::array{0, side - 1},
                                std::array{side - 1, 0});
    if (JumpPointSearch(BitGrid(grid)).find(corners.start, corners.goal, run).found) return grid;
  }
}

/// From corner to corner.
void drawn_map(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const Task corners{BitGrid::place(0, side - 1), BitGrid::place(side - 1, 0)};
  const HeightGrid grid = draw_map(side, corners);
  compare(state, grid, {corners});
  const BitGrid cells(grid);
  const auto count = static_cast<double>(cells.by_row().cells());
  constexpr double kMiB = 1024.0 * 1024.0;
  state.counters["bits_MiB"] = (count + static_cast<double>(cells.by_column().cells())) / 8 / kMiB;
  state.counters["astar_MiB"] = count * sizeof(CostTable::Key) / kMiB;
  state.counters["jps_MiB"] = count * (sizeof(CostTable::Key) + sizeof(GridPlace) + 1) / kMiB;
}

void drawn_map_any_angle(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const Task corners{BitGrid::place(0, side - 1), BitGrid::place(side - 1, 0)};
  compare_any_angle(state, draw_map(side, corners), {corners});
}

}  // namespace

#define ALATE_MAP(name) BENCHMARK_CAPTURE(longest_tasks, name, #name)->Iterations(3)->Unit(benchmark::kMillisecond)
ALATE_MAP(lak303d);
ALATE_MAP(brc202d);
ALATE_MAP(Boston_0_256);
ALATE_MAP(Berlin_1_512);
ALATE_MAP(Paris_1_1024);

#define ALATE_ANY_ANGLE(name) BENCHMARK_CAPTURE(any_angle, name, #name, 0)->Iterations(3)->Unit(benchmark::kMillisecond)
ALATE_ANY_ANGLE(arena);
ALATE_ANY_ANGLE(den312d);
ALATE_ANY_ANGLE(lak303d);
ALATE_ANY_ANGLE(brc202d);
ALATE_ANY_ANGLE(Boston_0_256);
ALATE_ANY_ANGLE(Berlin_1_512);
ALATE_ANY_ANGLE(Paris_1_1024);
BENCHMARK_CAPTURE(any_angle, Berlin_1_512_longest, "Berlin_1_512", 300)->Iterations(3)->Unit(benchmark::kMillisecond);

BENCHMARK(drawn_map)->RangeMultiplier(2)->Range(256, 4096)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(drawn_map_any_angle)->RangeMultiplier(2)->Range(512, 4096)->Iterations(3)->Unit(benchmark::kMillisecond);
