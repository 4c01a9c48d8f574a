// The lattice in single precision against the lattice in double precision.
#include "space/attitude_ants.hpp"

#include <gtest/gtest.h>

#include "aco/local_search/action_string.hpp"
#include "alate/core/stream.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

AttitudeState some_state(const AttitudeSpace& space, std::uint64_t seed) {
  Stream stream(seed, 0, 0);
  AttitudeState state = space.start();
  for (std::uint64_t moves = stream.below(12); moves > 0; --moves) state = space.next(state, stream.below(125));
  return state;
}

TEST(AttitudeAnts, SeeWhatTheLatticeSees) {
  const World world(test::konatowski_site(0.5, test::kLayoutF));
  const AttitudeSpace space(world, nullptr);
  const AttitudeAnts ants(world, space);
  Choices choices;
  Candidates candidates;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const AttitudeState state = some_state(space, seed);
    ants.look(state, choices);
    space.expand(state, candidates);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      EXPECT_NEAR(choices.cost[k], candidates.cost[k], 2e-5);
      EXPECT_NEAR(choices.to_goal[k], candidates.to_goal[k], 1e-5);
      EXPECT_NEAR(choices.x[k], candidates.x[k] - 7, 1e-5);
      EXPECT_NEAR(choices.guide[k], candidates.guide[k], 2e-4);
    }
    for (std::size_t k = candidates.size(); k < choices.cost.size(); ++k) EXPECT_FALSE(choices.cost[k] < 1e30F);
  }
}

TEST(AttitudeAnts, LimitsOfTheAircraftHoldForAnts) {
  Site site = test::konatowski_site(0.5, test::kLayoutA);
  site.vehicle.climb_rad = radians(5);
  const World world(site);
  const AttitudeSpace space(world, nullptr);
  const AttitudeAnts ants(world, space);
  Choices choices;
  Candidates candidates;
  ants.look(space.start(), choices);
  space.expand(space.start(), candidates);
  std::size_t closed = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    EXPECT_EQ(candidates.cost[k] == kInfinity, std::isinf(choices.cost[k]));
    closed += candidates.cost[k] == kInfinity ? 1U : 0U;
    const AttitudeState to = space.next(space.start(), k);
    EXPECT_EQ(candidates.cost[k] == kInfinity, space.move_cost(space.start(), to) == kInfinity);
  }
  EXPECT_GT(closed, 0U);
  EXPECT_LT(closed, candidates.size());
}

/// A string that arrives: the greedy walk on J + h.
std::vector<std::uint32_t> greedy_string(const AttitudeAnts& ants) {
  std::vector<std::uint32_t> actions;
  Choices choices;
  AttitudeState state = ants.start();
  while (!ants.is_goal(state) && actions.size() < 40) {
    ants.look(state, choices);
    std::uint32_t best = 0;
    for (std::uint32_t k = 0; k < 125; ++k)
      if (choices.cost[k] + choices.guide[k] < choices.cost[best] + choices.guide[best]) best = k;
    actions.push_back(best);
    state = ants.next(state, best);
  }
  return actions;
}

TEST(AttitudeAnts, PricesOfTailsAreThoseOfFlyingThem) {
  const World world(test::konatowski_site(0.5, test::kLayoutC));
  const AttitudeSpace space(world, nullptr);
  const AttitudeAnts ants(world, space);
  const std::vector<std::uint32_t> actions = greedy_string(ants);
  ASSERT_TRUE(ants.fly(actions));
  const std::size_t position = 2;
  AttitudeState state = ants.start();
  double before = 0;
  for (std::size_t i = 0; i < position; ++i) {
    const AttitudeState ahead = ants.next(state, actions[i]);
    before += ants.move_cost(state, ahead);
    state = ahead;
  }
  std::vector<TailNode> tail;
  ants.unroll(std::span(actions).subspan(position + 1), tail);
  TailPrices prices;
  const std::vector<float> costs(tail.size(), 0.0F);
  ants.price_tails({state, before, 1e9, std::span(actions).subspan(position + 1), tail, costs}, prices);
  std::size_t arrivals = 0;
  for (std::uint32_t k = 0; k < 125; ++k) {
    std::vector<std::uint32_t> changed = actions;
    changed[position] = k;
    const auto flight = ants.fly(changed);
    EXPECT_EQ(flight.has_value(), std::isfinite(prices.sums.total[k])) << k;
    if (!flight) continue;
    ++arrivals;
    EXPECT_NEAR(prices.sums.total[k], flight->cost, 1e-4 * flight->cost);
  }
  EXPECT_GT(arrivals, 1U);
}

TEST(ActionString, LeavesNothingThatOneChangeCouldGain) {
  const World world(test::konatowski_site(0.5, test::kLayoutA));
  const AttitudeSpace space(world, nullptr);
  const AttitudeAnts ants(world, space);
  Ant ant;
  ant.actions = greedy_string(ants);
  ant.cost = ants.fly(ant.actions)->cost;
  const double before = ant.cost;
  Executor executor;
  RunContext run(executor, {});
  EXPECT_TRUE(ActionString{}(ants, ant, kInfinity, run));
  EXPECT_LT(ant.cost, before);
  EXPECT_DOUBLE_EQ(ants.fly(ant.actions)->cost, ant.cost);
  for (std::size_t i = 0; i < ant.actions.size(); ++i) {
    for (std::uint32_t k = 0; k < 125; ++k) {
      std::vector<std::uint32_t> changed = ant.actions;
      changed[i] = k;
      const auto flight = ants.fly(changed);
      EXPECT_TRUE(!flight || flight->cost > ant.cost * (1 - 3e-6));
    }
  }
}

TEST(AttitudeAnts, ReachHoldsEveryRouteThatArrives) {
  const World world(test::konatowski_site(0.5, {}));
  const AttitudeSpace space(world, nullptr);
  const ReachBox box = AttitudeAnts(world, space).reach();
  const Vec3 goal(13, 19, 5);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(box.min[i], -20);
    EXPECT_GT(box.max[i], goal[i] + 20);
    EXPECT_LT(box.max[i] - box.min[i], 83);
  }
}

}  // namespace
}  // namespace alate
