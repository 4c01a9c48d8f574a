// The colony on a small space, and its policies one by one.
#include "aco/colony.hpp"

#include <gtest/gtest.h>

#include <map>

#include "aco/deposit/ant_system.hpp"
#include "aco/deposit/colony_system.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/deposit/rank_based.hpp"
#include "aco/heuristic/power.hpp"
#include "aco/local_search/none.hpp"
#include "aco/pheromone/hash_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/roulette.hpp"

namespace alate {
namespace {

/// Three moves on a line, left, stay, right, for `length` steps; every node costs 1 plus its distance from place 3. The
/// place -1 at step 1 may not be entered.
struct LineAnts {
  struct State {
    int place = 0;
    int step = 0;
  };
  int length = 5;

  static State start() { return {}; }
  static std::size_t actions() { return 3; }
  std::size_t step_limit() const { return static_cast<std::size_t>(length); }
  static float price(const State& at) { return 1.0F + static_cast<float>(std::abs(3 - at.place)); }
  static State next(const State& state, std::size_t k) {
    return {.place = state.place + static_cast<int>(k) - 1, .step = state.step + 1};
  }
  static Eigen::Vector3f place(const State& state) {
    return {static_cast<float>(state.place), static_cast<float>(state.step), 0};
  }
  static void look(const State& state, Choices& out) {
    out.resize(actions());
    std::ranges::fill(out.cost, std::numeric_limits<float>::infinity());
    for (std::size_t k = 0; k < actions(); ++k) {
      const State to = next(state, k);
      out.x[k] = static_cast<float>(to.place);
      out.y[k] = static_cast<float>(to.step);
      out.z[k] = out.guide[k] = 0;
      out.to_goal[k] = static_cast<float>(std::abs(3 - to.place));
      out.cost[k] = price(to);
    }
  }
  static bool is_free(const State& /*from*/, const State& to) { return to.place != -1 || to.step != 1; }
  bool is_goal(const State& state) const { return state.step == length; }
  std::optional<FlownActions> fly(std::span<const std::uint32_t> actions) const {
    FlownActions flight;
    State state = start();
    for (const std::uint32_t k : actions) {
      state = next(state, k);
      flight.cost += static_cast<double>(price(state));
      flight.costs.push_back(price(state));
      ++flight.moves;
    }
    return flight;
  }
};
static_assert(AntSpace<LineAnts>);

template <class Deposit>
using Policies = ColonyPolicies<PowerHeuristic, Roulette, Trail<HashCells>, Deposit, NoLocalSearch>;

template <class Deposit>
Colony<LineAnts, Policies<Deposit>> colony_with(const LineAnts& space, Deposit deposit, const TrailRule& rule) {
  return {space, Policies<Deposit>{{1}, {}, Trail<HashCells>(HashCells(0.5), rule), deposit, {}}, {.ants = 10}};
}

template <class Deposit>
void expect_to_learn(Deposit deposit, const TrailRule& rule) {
  const LineAnts space;
  auto colony = colony_with(space, deposit, rule);
  Executor executor;
  RunContext run(executor, {.iterations = 60});
  const Ant& best = colony.run(run);
  EXPECT_EQ(best.actions, (std::vector<std::uint32_t>{2, 2, 2, 1, 1}));
  EXPECT_DOUBLE_EQ(best.cost, 3 + 2 + 1 + 1 + 1);
  ASSERT_EQ(colony.history().size(), 60U);
  EXPECT_EQ(colony.history().front().known, 0);
  EXPECT_GT(colony.history().back().known, 0.5);
  EXPECT_LT(*colony.history().back().mean, *colony.history().front().mean);
}

TEST(Colony, FindsTheCheapestWayAndLearnsWithEveryDeposit) {
  expect_to_learn(AntSystem{50}, {.evaporation = 0.5});
  expect_to_learn(RankBased{50, 6}, {.evaporation = 0.5});
  expect_to_learn(MaxMin{.q = 50, .evaporation = 0.2}, {.evaporation = 0.2, .unknown_decays = true});
  expect_to_learn(ColonySystem{.q = 50, .evaporation = 0.1, .wear = 0.1}, {.evaporation = 0});
}

TEST(Colony, NeverEntersWhatIsNotFree) {
  const LineAnts space;
  auto colony = colony_with(space, AntSystem{50}, {});
  Executor executor;
  RunContext run(executor, {.iterations = 20});
  EXPECT_NE(colony.run(run).actions.front(), 0U);
}

TEST(Colony, HistoryIsInOrder) {
  const LineAnts space;
  auto colony = colony_with(space, AntSystem{50}, {});
  Executor executor;
  RunContext run(executor, {.iterations = 20});
  colony.run(run);
  double before = kInfinity;
  for (const IterationStats& stats : colony.history()) {
    EXPECT_EQ(stats.arrived, 1);
    EXPECT_LE(*stats.best, *stats.mean);
    EXPECT_LE(*stats.mean, *stats.worst);
    EXPECT_LE(*stats.best_so_far, std::min(before, *stats.best));
    before = *stats.best_so_far;
  }
}

/// Nobody arrives: the line is longer than the walk.
struct EndlessLine : LineAnts {
  static bool is_goal(const State& /*state*/) { return false; }
};

TEST(Colony, AnAntThatFliesPastTheGoalEndsThereOnRequestButIsNoRoute) {
  const EndlessLine space{{.length = 12}};
  const auto arrived = [&](float end_within_m) {
    Colony<EndlessLine, Policies<AntSystem>> colony(space,
                                                    {{0}, {}, Trail<HashCells>(HashCells(0.5), {}), AntSystem{50}, {}},
                                                    {.ants = 200, .end_within_m = end_within_m});
    Executor executor;
    RunContext run(executor, {.iterations = 3});
    EXPECT_FALSE(colony.run(run).arrived());
    EXPECT_FALSE(colony.history().back().best);
    return colony.history().front().arrived;
  };
  EXPECT_EQ(arrived(0), 0);
  EXPECT_GT(arrived(2), 0);
}

/// Remembers what was added to each key.
struct Ledger {
  std::map<TrailKey, double> sums;
  TrailLevels all{TrailRule{}};
  void add(TrailKey key, double amount) { sums[key] += amount; }
  TrailLevels& levels() { return all; }
};

Ant ant_of(double cost, TrailKey key) {
  Ant ant;
  ant.cost = cost;
  ant.keys = {key};
  return ant;
}

TEST(Deposit, AntSystemLeavesQOverJOfEveryArrival) {
  const std::vector<Ant> ants{ant_of(10, 1), ant_of(20, 1), ant_of(kInfinity, 2)};
  Ledger ledger;
  AntSystem{50}(ledger, {ants, ants[0], ants[0], 1});
  EXPECT_DOUBLE_EQ(ledger.sums.at(1), 50.0 / 10 + 50.0 / 20);
  EXPECT_FALSE(ledger.sums.contains(2));
}

TEST(Deposit, RanksWeighTheBestAndTheBestSoFarMost) {
  const std::vector<Ant> ants{ant_of(30, 3), ant_of(10, 1), ant_of(20, 2)};
  const Ant best = ant_of(5, 9);
  Ledger ledger;
  RankBased{60, 3}(ledger, {ants, ants[1], best, 1});
  EXPECT_DOUBLE_EQ(ledger.sums.at(1), 2 * 60.0 / 10);
  EXPECT_DOUBLE_EQ(ledger.sums.at(2), 1 * 60.0 / 20);
  EXPECT_FALSE(ledger.sums.contains(3));
  EXPECT_DOUBLE_EQ(ledger.sums.at(9), 3 * 60.0 / 5);
}

TEST(Deposit, MaxMinTakesTheBestSoFarEveryThirdTime) {
  const std::vector<Ant> ants{ant_of(10, 1)};
  const Ant best = ant_of(5, 9);
  MaxMin deposit{.q = 50};
  Ledger ledger;
  for (std::uint64_t iteration = 1; iteration <= 6; ++iteration)
    deposit(ledger, Harvest{ants, ants[0], best, iteration});
  EXPECT_DOUBLE_EQ(ledger.sums.at(1), 4 * 50.0 / 10);
  EXPECT_DOUBLE_EQ(ledger.sums.at(9), 2 * 50.0 / 5);
}

}  // namespace
}  // namespace alate
