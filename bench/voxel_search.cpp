// Exact search among voxels: the 1 000 longest tasks of benchmark maps, ours against the textbook's A* in the same run.
//
// `_ms`: median of a query. `speedup`: times as fast in all, processor time, so that a busy machine counts less.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <numeric>
#include <queue>

#include "../tests/support/shared_data.hpp"
#include "../tests/support/voxel_sites.hpp"
#include "data/scen_file.hpp"
#include "search/voxel/voxel_astar.hpp"
#include "search/voxel/voxel_jps.hpp"

namespace {

using namespace alate;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Of the shortest way were all cells free.
double free_length(const VoxelCell& a, const VoxelCell& b) {
  std::array<int, 3> sides{std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])};
  std::ranges::sort(sides);
  return (std::numbers::sqrt3 - std::numbers::sqrt2) * sides[0] + (std::numbers::sqrt2 - 1) * sides[1] + sides[2];
}

/// A* word for word: a priority queue, lengths and closed cells in arrays that each query makes anew.
double literal_astar(const VoxelGrid& voxels, const VoxelCell& start, const VoxelCell& goal) {
  using Entry = std::pair<double, VoxelCell>;
  std::vector<double> lengths(voxels.count(), std::numeric_limits<double>::infinity());
  std::vector<bool> closed(voxels.count());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  lengths[voxels.index(start)] = 0;
  open.emplace(free_length(start, goal), start);
  while (!open.empty()) {
    const VoxelCell cell = open.top().second;
    open.pop();
    if (closed[voxels.index(cell)]) continue;
    if (cell == goal) break;
    closed[voxels.index(cell)] = true;
    for (const auto& shift : kVoxelShifts) {
      if (shift == VoxelCell{} || !test::is_free_step(voxels, cell, shift)) continue;
      const VoxelCell next{cell[0] + shift[0], cell[1] + shift[1], cell[2] + shift[2]};
      const double axes = std::abs(shift[0]) + std::abs(shift[1]) + std::abs(shift[2]);
      const double length = lengths[voxels.index(cell)] + std::sqrt(axes);
      if (!(length < lengths[voxels.index(next)])) continue;
      lengths[voxels.index(next)] = length;
      open.emplace(length + free_length(next, goal), next);
    }
  }
  return lengths[voxels.index(goal)];
}

/// What one search took.
struct Tally {
  std::vector<double> seconds;
  double length = 0;

  template <class Query>
  void time(const Query& query) {
    const double start = cpu_s();
    length += query();
    seconds.push_back(cpu_s() - start);
  }
  double sum() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
  double median_ms() {
    std::ranges::nth_element(seconds, seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2));
    return seconds[seconds.size() / 2] * 1e3;
  }
};

template <class Search>
void time(Search& search, const VoxelScenRow& row, Tally& tally) {
  Executor executor(1);
  RunContext run(executor, {});
  tally.time([&] { return search.find(VoxelBits::place(row.start), VoxelBits::place(row.goal), run).length.value(); });
}

void longest_tasks(benchmark::State& state, const std::string& name) {
  constexpr std::size_t kRows = 1000;
  constexpr std::size_t kLiteralEvery = 20;  // It makes its arrays anew each time.
  std::vector<Fault> faults;
  auto scen = read_voxel_scen_file(test::shared_data("movingai/3d/" + name + ".3dmap.3dscen").string(), faults);
  if (!scen) return state.SkipWithError("needs the shared data");
  std::ranges::stable_sort(scen->rows, std::ranges::greater{}, &VoxelScenRow::optimum);
  const VoxelBits bits(scen->voxels);
  VoxelJps jps(bits);
  VoxelAStar astar(bits);
  Tally jps_tally, astar_tally, literal, jps_beside_literal;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kRows; ++i) {
      const VoxelScenRow& row = scen->rows[i];
      time(jps, row, jps_tally);
      time(astar, row, astar_tally);
      if (i % kLiteralEvery != 0) continue;
      literal.time([&] { return literal_astar(scen->voxels, row.start, row.goal); });
      time(jps, row, jps_beside_literal);
    }
  }
  if (jps_tally.length != astar_tally.length || std::abs(literal.length - jps_beside_literal.length) > 1e-6)
    return state.SkipWithError("lengths differ");
  state.counters["jps_ms"] = jps_tally.median_ms();
  state.counters["astar_ms"] = astar_tally.median_ms();
  state.counters["literal_ms"] = literal.median_ms();
  state.counters["jps_over_astar"] = astar_tally.sum() / jps_tally.sum();
  state.counters["jps_speedup"] = literal.sum() / jps_beside_literal.sum();
}

}  // namespace

#define ALATE_MAP(name) BENCHMARK_CAPTURE(longest_tasks, name, #name)->Iterations(1)->Unit(benchmark::kMillisecond)
ALATE_MAP(Simple);
ALATE_MAP(Complex);
