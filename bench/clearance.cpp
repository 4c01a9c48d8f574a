// Clearance of legs over Jacksboro: exact and pruned, against sampling the bilinear ground every 5 m.
//
// `speedup` compares on the same legs in the same run (times as fast as sampling).
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include "alate/core/stream.hpp"
#include "alate/world/world.hpp"

namespace {

using namespace alate;

const World& jacksboro() {
  static const World world = [] {
    Scenario scenario;
    scenario.terrain = TerrainSpec{
        .dem = ALATE_SOURCE_DIR "/examples/jacksboro/jacksboro.tif", .clearance_m = 60, .ceiling_agl_m = 300};
    scenario.start.place = {.lat_deg = 36.378, .lon_deg = -84.1263, .agl_m = 120};
    scenario.goal = {.place = {.lat_deg = 36.2733, .lon_deg = -84.3825, .agl_m = 120}};
    return World(load_site(scenario));
  }();
  return world;
}

/// Legs as a planner tries them: fans of 64 from 64 places 60 to 300 m above ground, climbing at most 8 degrees.
std::vector<Segment> legs_of(double length_m) {
  constexpr std::size_t kFan = 64;
  const World& world = jacksboro();
  const Box2& area = std::get<HeightRaster>(world.site().ground).area;
  std::vector<Segment> legs;
  for (std::uint64_t i = 0; legs.size() < kFan * kFan; ++i) {
    Stream stream(1, 0, i);
    const Vec2 margin = Vec2::Constant(length_m + 1500);
    const Vec2 size = area.max - area.min - 2 * margin;
    const Vec2 from = area.min + margin + Vec2(stream.uniform(), stream.uniform()).cwiseProduct(size);
    const Vec3 a{from.x(), from.y(), world.height(from).value() + 60 + 240 * stream.uniform()};
    for (std::size_t leg = 0; leg < kFan; ++leg) {
      const double heading = 2 * kPi * stream.uniform();
      const double climb = radians(16 * stream.uniform() - 8);
      legs.push_back({a, a + length_m * (std::cos(climb) * direction_of(heading) + Vec3{0, 0, std::sin(climb)})});
    }
  }
  return legs;
}

double sampled(const World& world, const Segment& leg) {
  constexpr double kStepMetres = 5;
  const auto& raster = std::get<HeightRaster>(world.site().ground);
  const int steps = static_cast<int>(std::ceil(leg.length() / kStepMetres));
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const Vec3 at = leg.at(static_cast<double>(i) / steps);
    const auto ground = raster.height(at.head<2>());
    lowest = std::min(lowest, ground ? at.z() - *ground : -std::numeric_limits<double>::infinity());
  }
  return lowest;
}

/// Processor time, so that a busy machine does not count.
template <class Query>
double seconds_for(const std::vector<Segment>& legs, const Query& query) {
  const std::clock_t start = std::clock();
  for (const Segment& leg : legs) benchmark::DoNotOptimize(query(leg));
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Times `query` leg by leg and, outside the clock of the benchmark, sampling of the same legs.
template <class Query>
void against_sampling(benchmark::State& state, const Query& query) {
  const World& world = jacksboro();
  const auto legs = legs_of(static_cast<double>(state.range(0)));
  double ours = 0;
  double theirs = 0;
  for (auto _ : state) {
    const double pass = seconds_for(legs, query);
    ours += pass;
    state.SetIterationTime(pass);
    theirs += seconds_for(legs, [&](const Segment& leg) { return sampled(world, leg); });
  }
  const auto count = static_cast<double>(legs.size()) * static_cast<double>(state.iterations());
  state.counters["ns_per_leg"] = ours / count * 1e9;
  state.counters["sampling_ns"] = theirs / count * 1e9;
  state.counters["speedup"] = theirs / ours;
}

void clearance(benchmark::State& state) {
  against_sampling(state, [](const Segment& leg) { return jacksboro().clearance(leg); });
}

void is_free(benchmark::State& state) {
  against_sampling(state, [](const Segment& leg) { return jacksboro().is_free(leg); });
}

void load(benchmark::State& state) {
  const Scenario scenario = jacksboro().site().scenario;
  for (auto _ : state) benchmark::DoNotOptimize(World(load_site(scenario)));
}

}  // namespace

BENCHMARK(clearance)->Arg(26)->Arg(100)->Arg(300)->Arg(420)->Arg(3000)->UseManualTime();
BENCHMARK(is_free)->Arg(26)->Arg(100)->Arg(300)->Arg(420)->Arg(3000)->UseManualTime();
BENCHMARK(load)->Unit(benchmark::kMillisecond);
