#include "search/beam.hpp"

#include <gtest/gtest.h>

#include "alate/core/stream.hpp"
#include "string_space.hpp"

namespace alate {
namespace {

using test::LineSpace;

struct Searched {
  SearchResult result;
  std::uint64_t passes = 0;
  Stop stop = Stop::finished;
};

Searched search(const LineSpace& space, BeamOptions options, RunOptions limits = {}, int threads = 1) {
  Executor executor(threads);
  RunContext run(executor, std::move(limits));
  SearchResult result = Beam(space, options).run(run);
  return {std::move(result), run.iterations(), run.stop()};
}

/// Random costs, one place in eight a wall.
LineSpace random_line(std::uint64_t seed) {
  LineSpace space{.costs = std::vector<std::vector<double>>(12, std::vector<double>(25))};
  Stream stream(seed, 0, 0);
  for (auto& row : space.costs)
    for (double& cost : row) cost = stream.below(8) == 0 ? -1 : 1 + 10 * stream.uniform();
  return space;
}

/// Cheapest way by going through all places step by step.
double optimum(const LineSpace& space) {
  std::vector<double> best(space.costs.front().size(), kInfinity);
  best[best.size() / 2] = 0;
  for (const auto& row : space.costs) {
    std::vector<double> next(row.size(), kInfinity);
    for (std::size_t place = 0; place < row.size(); ++place)
      for (std::size_t from = place == 0 ? 0 : place - 1; from < std::min(place + 2, row.size()); ++from)
        if (row[place] >= 0) next[place] = std::min(next[place], best[from] + row[place]);
    best = next;
  }
  return *std::ranges::min_element(best);
}

TEST(Beam, FindsTheOptimumOnceItIsWideEnough) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const LineSpace space = random_line(seed);
    const Searched run = search(space, {.width = 32});
    EXPECT_EQ(run.result.found, optimum(space) < kInfinity);
    EXPECT_NEAR(run.result.found ? run.result.cost : kInfinity, optimum(space), 1e-9) << seed;
  }
}

TEST(Beam, MorePassesAreNeverWorse) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    double before = kInfinity;
    for (std::uint64_t passes = 1; passes <= 5; ++passes) {
      const Searched run = search(random_line(seed), {.width = 1}, {.iterations = passes});
      EXPECT_LE(run.result.cost, before);
      EXPECT_LE(run.passes, passes);
      before = run.result.cost;
    }
  }
}

TEST(Beam, ActionsLeadToTheCost) {
  const LineSpace space = random_line(4);
  const Searched run = search(space, {.width = 4});
  ASSERT_TRUE(run.result.found);
  double cost = 0;
  LineSpace::State state = space.start();
  for (const std::size_t k : run.result.actions) {
    state = space.next(state, k);
    cost += space.cost(state);
  }
  EXPECT_TRUE(space.is_goal(state));
  EXPECT_DOUBLE_EQ(cost, run.result.cost);
}

TEST(Beam, AnyNumberOfThreadsGivesTheSameBits) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Searched one = search(random_line(seed), {.width = 3});
    for (const int threads : {2, 8}) {
      const Searched many = search(random_line(seed), {.width = 3}, {}, threads);
      EXPECT_EQ(one.result.actions, many.result.actions);
      EXPECT_EQ(one.result.cost, many.result.cost);
      EXPECT_EQ(one.result.expansions, many.result.expansions);
    }
  }
}

TEST(Beam, DoesNotSpinWhenNothingIsLeft) {
  // One way only: the first pass keeps everything.
  const LineSpace space{.costs = {{1}, {1}, {1}}};
  const Searched run = search(space, {.width = 2}, {.iterations = 1000000000, .time_limit_s = 60});
  EXPECT_EQ(run.passes, 1U);
  EXPECT_EQ(run.stop, Stop::finished);
  EXPECT_EQ(run.result.cost, 3);
}

TEST(Beam, EndsAtTheGreatestWidth) {
  const Searched run = search(random_line(2), {.width = 1, .max_width = 4}, {.time_limit_s = 60});
  EXPECT_EQ(run.passes, 3U);
  EXPECT_EQ(run.stop, Stop::finished);
}

}  // namespace
}  // namespace alate
