// Lengths of Dubins paths: one at a time and in batches, against the six words as published and against OMPL where it
// is installed (Debian's libompl-dev).
//
// `per_pair` is the time of one length. Every way must give the same lengths, or the run fails.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "alate/core/stream.hpp"
#include "space/dubins/dubins_batch.hpp"
#include "space/dubins/dubins_path.hpp"
#include "space/dubins_reference.hpp"
#ifdef ALATE_HAS_OMPL
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#endif

namespace {

using namespace alate;

constexpr double kRadius_m = 66.67;
constexpr std::size_t kPairs = 4096;

/// Pairs of poses at random in a square of 20 radii: near and far ones.
struct Pairs {
  std::vector<PlanarPose> from, to;
  PoseColumns from_columns, to_columns;
  std::vector<double> length_m;
};

const Pairs& pairs() {
  static const Pairs result = [] {
    Pairs made;
    Stream stream(1, 0, 0);
    const auto place = [&] { return 20 * kRadius_m * stream.uniform(); };
    // OMPL refuses a heading of exactly pi.
    const auto heading = [&] { return (1 - 1e-6) * std::numbers::pi * (2 * stream.uniform() - 1); };
    for (std::size_t i = 0; i < kPairs; ++i) {
      for (auto* poses : {&made.from, &made.to}) {
        const double x = place();
        const double y = place();
        poses->push_back(planar_pose(x, y, heading()));
      }
      made.from_columns.push_back(made.from.back());
      made.to_columns.push_back(made.to.back());
      made.length_m.push_back(reference::shortest(made.from.back(), made.to.back(), kRadius_m));
    }
    return made;
  }();
  return result;
}

void require_equal(std::size_t pair, double length_m) {
  if (!(std::abs(length_m - pairs().length_m[pair]) <= 1e-9 * length_m))
    throw std::runtime_error("lengths of Dubins paths differ");
}

void per_pair(benchmark::State& state) {
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(kPairs), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Length>
void one_at_a_time(benchmark::State& state, Length length) {
  for (std::size_t i = 0; i < kPairs; ++i) require_equal(i, length(i));
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPairs; ++i) benchmark::DoNotOptimize(length(i));
  }
  per_pair(state);
}

void singly(benchmark::State& state) {
  const Pairs& all = pairs();
  one_at_a_time(state, [&](std::size_t i) { return dubins_length(all.from[i], all.to[i], kRadius_m); });
}
BENCHMARK(singly);

/// With the word and its pieces.
void paths(benchmark::State& state) {
  const Pairs& all = pairs();
  one_at_a_time(state, [&](std::size_t i) { return shortest_dubins(all.from[i], all.to[i], kRadius_m).length_m; });
}
BENCHMARK(paths);

void batch(benchmark::State& state) {
  const Pairs& all = pairs();
  AlignedDoubles length_m;
  dubins_lengths(all.from_columns, all.to_columns, kRadius_m, length_m);
  for (std::size_t i = 0; i < kPairs; ++i) require_equal(i, length_m[i]);
  for (auto _ : state) {
    dubins_lengths(all.from_columns, all.to_columns, kRadius_m, length_m);
    benchmark::DoNotOptimize(length_m.data());
    benchmark::ClobberMemory();
  }
  per_pair(state);
}
BENCHMARK(batch);

void batch_to_one(benchmark::State& state) {
  const Pairs& all = pairs();
  AlignedDoubles length_m;
  for (auto _ : state) {
    dubins_lengths(all.from_columns, all.to.front(), kRadius_m, length_m);
    benchmark::DoNotOptimize(length_m.data());
    benchmark::ClobberMemory();
  }
  per_pair(state);
}
BENCHMARK(batch_to_one);

/// Shkel, Lumelsky 2001, all six words.
void literal(benchmark::State& state) {
  const Pairs& all = pairs();
  one_at_a_time(state, [&](std::size_t i) { return reference::shortest<double>(all.from[i], all.to[i], kRadius_m); });
}
BENCHMARK(literal);

#ifdef ALATE_HAS_OMPL
void ompl_distance(benchmark::State& state) {
  namespace ob = ompl::base;
  const auto space = std::make_shared<ob::DubinsStateSpace>(kRadius_m);
  const auto states = [&](const std::vector<PlanarPose>& poses) {
    std::vector<ob::ScopedState<ob::DubinsStateSpace>> made;
    for (const PlanarPose& pose : poses) {
      made.emplace_back(space);
      made.back()->setXY(pose.x, pose.y);
      made.back()->setYaw(pose.heading);
    }
    return made;
  };
  const auto from = states(pairs().from);
  const auto to = states(pairs().to);
  one_at_a_time(state, [&](std::size_t i) { return space->distance(from[i].get(), to[i].get()); });
}
BENCHMARK(ompl_distance);
#endif

}  // namespace
