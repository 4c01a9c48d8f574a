// Ants on grids: formulas by hand, draws, walks, deposits, shortcuts.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "aco/colony.hpp"
#include "aco/deposit/bounded_ant_system.hpp"
#include "aco/deposit/max_min.hpp"
#include "aco/heuristic/goal_table.hpp"
#include "aco/heuristic/multi_factor.hpp"
#include "aco/local_search/none.hpp"
#include "aco/local_search/sight.hpp"
#include "aco/transition/move_table.hpp"
#include "aco/walk/grid_walk.hpp"
#include "support/grid_sites.hpp"
#include "support/grid_stands.hpp"

namespace alate {
namespace {

using test::corner_space;
using test::grid_of;

constexpr unsigned kEast = 0, kNorthEast = 1, kNorth = 2;

/// Lower left cell of 3 x 3, heights 1 at the start, 3 east of it, 2 north-east, 0 north: J = {E, NE, N}.
class MultiFactorByHand : public testing::Test {
 protected:
  static HeightGrid hills() {
    HeightGrid grid = grid_of({"...", "...", "..."});
    grid.height_m = {0, 0, 0, 0, 2, 0, 1, 3, 0};
    return grid;
  }

  GridStands at(unsigned came, unsigned tabu = 0) const {
    return test::stands_at({.cell = space_.start(), .came = came, .tabu = tabu});
  }
  float eta(unsigned direction, unsigned came, const MultiFactorRule& rule) const {
    return MultiFactor(space_, rule).eta(at(came))[direction][0];
  }

  HeightGrid grid_ = hills();
  GridSpace space_ = corner_space(grid_, 1.4);
  double far_ = std::sqrt(5.0);                                         // E and N to the goal
  double near_ = std::numbers::sqrt2;                                   // NE
  double phi_near_ = 10 * (far_ - near_) / (far_ - near_ + 0.001) + 1;  // eq. (1)
};

TEST_F(MultiFactorByHand, SumsUpEquations1To4And12) {
  // |h(i)-h(j)|: E 2, NE 1, N 1; signed: -2, -1, 1, range 3.
  EXPECT_NEAR(eta(kEast, kEast, {}), 5 + 1 + 1 + 1, 1e-5);                                        // straight on
  EXPECT_NEAR(eta(kNorthEast, kEast, {}), 5.0 / 3 + 1 / 1.4 + phi_near_ + 10 / 3.001 + 1, 1e-4);  // a turn
  EXPECT_NEAR(eta(kNorth, kEast, {}), 5.0 / 3 + 1 + 1 + 10 / 3.001 + 1, 1e-4);
}

TEST_F(MultiFactorByHand, TheFirstMoveSharesTheSafety) {
  constexpr unsigned kFirst = GridSpace::kNoDirection;
  EXPECT_NEAR(eta(kEast, kFirst, {}), 10.0 / 3 + 3, 1e-5);
  EXPECT_NEAR(eta(kEast, kFirst, {.first_move = MultiFactorRule::FirstMove::straight}), 5 + 3, 1e-5);
}

TEST_F(MultiFactorByHand, KeepsItsVariants) {
  EXPECT_NEAR(eta(kNorth, kEast, {.range = MultiFactorRule::Range::absolute_heights}), 5.0 / 3 + 1 + 1 + 10 / 1.001 + 1,
              1e-4);
  EXPECT_NEAR(eta(kNorthEast, kEast, {.join = MultiFactorRule::Join::product}),
              5.0 / 3 / 1.4 * phi_near_ * (10 / 3.001 + 1), 1e-3);
  EXPECT_NEAR(eta(kEast, kEast, {.step_factor = false}), 5 + 1 + 1, 1e-5);
  EXPECT_NEAR(eta(kEast, kEast, {.theta = 0.8}), 8 + 1 + 1 + 1, 1e-5);
  EXPECT_NEAR(eta(kNorth, kEast, {.theta = 0.8}), 2.0 / 3 + 1 + 1 + 10 / 3.001 + 1, 1e-4);
}

TEST_F(MultiFactorByHand, VisitedNeighboursLeaveJ) {
  const MultiFactor factors(space_, {});
  const GridStands stands = at(kEast, 1U << kNorthEast);
  EXPECT_NEAR(factors.eta(stands)[kNorth][0], 5.0 / 2 + 1 + 1 + (10 / 3.001 + 1), 1e-4);
  EXPECT_EQ(factors.weights(stands)[kNorthEast][0], 0);
}

TEST_F(MultiFactorByHand, AnAntWithoutANeighbourHasNoDirection) {
  Trail<MoveCells> trail(MoveCells(space_.cells()), {.initial = 20, .unknown_decays = true});
  MultiFactor factors(space_, {});
  factors.prepare(trail);
  Stream stream(1, 1, 1);
  const LaneBits directions = factors(at(kEast, 0xFF), {&stream, &stream, &stream, &stream});
  for (std::size_t i = 0; i < kAntLanes; ++i) EXPECT_EQ(directions[i], GridSpace::kNoDirection);
}

TEST_F(MultiFactorByHand, WeighsByTrailPowerAndMu) {
  Trail<MoveCells> trail(MoveCells(space_.cells()), {.initial = 20, .unknown_decays = true});
  trail.add(MoveCells::key(space_.start(), kEast), 5);
  MultiFactor factors(space_, {.mu_power = 1, .a = 1, .b = 3});
  factors.prepare(trail);
  const MoveLanes weights = factors.weights(at(kEast));
  const double east = 25 * std::pow(8, 3) / (1 + 3 * far_);  // eqs. (5), (6)
  const double north = 20 * std::pow(5.0 / 3 + 3 + 10 / 3.001, 3) / (1 + 3 * far_);
  EXPECT_NEAR(weights[kEast][0], east, 1e-4 * east);
  EXPECT_NEAR(weights[kNorth][0], north, 1e-4 * north);
  EXPECT_EQ(weights[4][0], 0);
  MultiFactor inside(space_, {.mu_power = 1, .mu_place = MultiFactorRule::MuPlace::inside, .a = 1, .b = 3});
  inside.prepare(trail);
  const double cubed = 25 * std::pow(8 / (1 + 3 * far_), 3);
  EXPECT_NEAR(inside.weights(at(kEast))[kEast][0], cubed, 1e-4 * cubed);
}

LaneStreams pointers(std::array<Stream, kAntLanes>& streams) {
  return {streams.data(), &streams[1], &streams[2], &streams[3]};
}

TEST(MoveTable, DrawsInProportionAmongUnvisited) {
  AlignedFloats weights(16);
  for (std::size_t d = 0; d < 8; ++d) weights[8 + d] = d == 5 ? 0.0F : static_cast<float>(d + 1);
  const MoveTable table(weights, 1, 0);
  std::array<Stream, kAntLanes> streams{Stream{1, 1, 1}, {1, 1, 2}, {1, 1, 3}, {1, 1, 4}};
  constexpr std::size_t kDraws = 200000;
  for (const unsigned tabu : {0U, 0b10000100U, 0b11011111U}) {
    std::array<int, 8> counts{};
    std::size_t fitting = 0;
    double sum = 0;
    for (unsigned d = 0; d < 8; ++d) sum += ((tabu >> d) & 1U) != 0 ? 0 : double{weights[8 + d]};
    for (std::size_t i = 0; i < kDraws; i += kAntLanes) {
      const LaneBits drawn = table(test::stands_at({.cell = 1, .tabu = tabu}), pointers(streams));
      for (std::size_t lane = 0; lane < kAntLanes; ++lane)
        if (const auto d = static_cast<unsigned>(drawn[lane]); d < 8) ++counts[d], ++fitting;
    }
    EXPECT_EQ(fitting, sum > 0 ? kDraws : 0U);
    for (unsigned d = 0; sum > 0 && d < 8; ++d) {
      const double chance = ((tabu >> d) & 1U) != 0 ? 0 : double{weights[8 + d]} / sum;
      EXPECT_NEAR(counts[d], kDraws * chance, 5 * std::sqrt(kDraws * chance * (1 - chance))) << tabu << ' ' << d;
    }
  }
}

TEST(MoveTable, TakesTheHeaviestWithChanceQ0) {
  AlignedFloats weights(8, 1.0F);
  weights[3] = 2;
  const MoveTable table(weights, 1, 1);
  std::array<Stream, kAntLanes> streams{Stream{1, 1, 1}, {1, 1, 2}, {1, 1, 3}, {1, 1, 4}};
  EXPECT_EQ(table(test::stands_at({}), pointers(streams))[0], 3);
  EXPECT_EQ(table(test::stands_at({.tabu = 1U << 3U}), pointers(streams))[0], 0);
}

template <class Choice, class Deposit>
using Policies = GridPolicies<Choice, Deposit, NoLocalSearch>;

struct Nothing {
  template <class Trail>
  void operator()(Trail&, const Harvest&) const {}
};

std::vector<Ant> walked(const GridSpace& space, const GridWalkOptions& options) {
  using Kind = Policies<MoveTable, Nothing>;
  Kind policies{MoveTable(goal_distance_table(space, 1), 1, 0), Trail<MoveCells>(MoveCells(space.cells()), {}), {}, {}};
  GridWalk<Kind> walk(space, options);
  std::vector<Ant> ants(options.ants);
  for (std::size_t a = 0; a < ants.size(); ++a) ants[a].index = a;
  Executor executor;
  RunContext run(executor, {});
  for (int iteration = 0; iteration < 2; ++iteration) walk(policies, ants, Ant{}, run);
  return ants;
}

TEST(GridWalk, NoAntVisitsACellTwiceAndDeadOnesHaveNoCost) {
  const HeightGrid grid = test::drawn_grid(20, 2);
  const GridSpace space = corner_space(grid, 1.4);
  constexpr int kAnts = 3000;  // of whom so many share a slot that marks of visited cells are used again
  int arrived = 0;
  for (const Ant& ant : walked(space, {.ants = kAnts})) {
    std::set<GridSpace::Cell> visited{space.start()};
    GridSpace::Cell cell = space.start();
    for (std::size_t i = 0; i < ant.actions.size(); ++i) {
      ASSERT_NE((space.open(cell) >> ant.actions[i]) & 1U, 0U);
      EXPECT_EQ(ant.keys[i], MoveCells::key(cell, ant.actions[i]));
      cell = space.neighbour(cell, ant.actions[i]);
      ASSERT_TRUE(visited.insert(cell).second);
    }
    EXPECT_EQ(ant.arrived(), cell == space.goal());
    if (ant.arrived()) {
      EXPECT_DOUBLE_EQ(ant.cost, space.score(ant.actions));
      ++arrived;
    }
  }
  EXPECT_GT(arrived, 0);
  EXPECT_LT(arrived, kAnts);
}

TEST(GridWalk, AntsThatMayStepBackAllArrive) {
  const HeightGrid grid = test::drawn_grid(20, 2);
  const GridSpace space = corner_space(grid, 1.4);
  for (const Ant& ant : walked(space, {.ants = 200, .step_backs = 1000})) EXPECT_TRUE(space.fly(ant.actions));
}

/// Eqs. (7)-(11) on one move that two ants took.
TEST(BoundedAntSystem, FollowsTheEquations) {
  Trail<MoveCells> trail(MoveCells(2), {.evaporation = 0.3, .initial = 20, .unknown_decays = true});
  std::vector<Ant> ants(3);
  for (const std::size_t a : {0U, 1U}) ants[a].keys = {8};
  ants[0].cost = 50;
  ants[0].sum = 25;
  ants[1].cost = 100;
  ants[1].sum = 20;
  ants[2].keys = {9};  // dead
  BoundedAntSystem deposit;
  trail.evaporate();
  deposit(trail, Harvest{ants, ants[0], ants[0], 1});
  EXPECT_NEAR(trail.level(8), 0.7 * 20 + 2 + 1, 1e-5);
  EXPECT_NEAR(trail.level(9), 14, 1e-5);
  EXPECT_NEAR(deposit.evaporation, 0.285, 1e-12);
  trail.evaporate();
  deposit.over = BoundedAntSystem::Over::length;
  deposit(trail, Harvest{ants, ants[0], ants[0], 2});
  EXPECT_NEAR(trail.level(8), 0.715 * 17 + 4 + 5, 1e-4);
  EXPECT_NEAR(trail.level(9), 0.715 * 14, 1e-4);
  for (int i = 0; i < 8; ++i) {
    trail.evaporate();
    deposit(trail, Harvest{ants, ants[0], ants[0], 3});
  }
  EXPECT_EQ(deposit.evaporation, 0.2);
  EXPECT_NEAR(trail.level(9), 10, 1e-5);  // eq. (11) on each trail
  EXPECT_LE(trail.level(8), 40);
}

TEST(BoundedAntSystem, WholeMatrixBoundsActOnlyTogether) {
  using Bounds = BoundedAntSystem::Bounds;
  std::vector<Ant> ants(1);
  BoundedAntSystem deposit{.bounds = Bounds::whole_matrix};
  Trail<MoveCells> trail(MoveCells(1), {.evaporation = 0.3, .initial = 20, .unknown_decays = true});
  std::vector<float> levels;
  for (int i = 0; i < 4; ++i) {
    trail.evaporate();
    deposit(trail, Harvest{ants, ants[0], ants[0], 1});
    levels.push_back(trail.level(0));
  }
  // 20 -> 14 -> 10.01 -> 7.30; then all are below 10: 10 before evaporation with rho = 0.3 * 0.95^3
  EXPECT_NEAR(levels[1], 14 * 0.715, 1e-4);
  EXPECT_NEAR(levels[2], 14 * 0.715 * (1 - 0.27075), 1e-4);
  EXPECT_NEAR(levels[3], 10 * (1 - 0.2572125), 1e-4);
}

TEST(Sight, PullsARouteStraightAndKeepsOffBlockedCells) {
  const HeightGrid grid = test::drawn_grid(30, 5);
  const GridSpace space = corner_space(grid, std::numbers::sqrt2);
  Executor executor;
  RunContext run(executor, {});
  Sight sight(12);
  int shortened = 0;
  for (Ant ant : walked(space, {.ants = 50, .step_backs = 10000})) {
    const double before = ant.cost;
    const bool changed = sight(space, ant, kInfinity, run);
    const auto flight = space.fly(ant.actions);
    ASSERT_TRUE(flight);
    EXPECT_EQ(ant.cost, flight->cost);
    EXPECT_EQ(changed, ant.cost < before);
    shortened += changed ? 1 : 0;
  }
  EXPECT_GT(shortened, 40);
  const HeightGrid open = test::drawn_grid(8, 1, 0);
  const GridSpace square = corner_space(open, std::numbers::sqrt2);
  Ant around;
  for (int i = 0; i < 7; ++i) around.actions.push_back(kEast);
  for (int i = 0; i < 7; ++i) around.actions.push_back(kNorth);
  EXPECT_TRUE(Sight(14)(square, around, kInfinity, run));
  EXPECT_DOUBLE_EQ(around.cost, 7 * std::numbers::sqrt2);
}

TEST(GridColony, RepeatsTheBestSoThatItsScoreNeverRises) {
  HeightGrid grid = test::drawn_grid(20, 2);
  const GridSpace space = corner_space(grid, 1.4, {.height_dev = 100, .turns = 1});
  using Kind = Policies<MultiFactor, BoundedAntSystem>;
  Colony<GridSpace, Kind> colony(
      space,
      Kind{MultiFactor(space, {}),
           Trail<MoveCells>(MoveCells(space.cells()), {.evaporation = 0.3, .initial = 20, .unknown_decays = true}),
           {},
           {}},
      {.ants = 30, .iterations = 10, .repeat_best = true});
  Executor executor;
  RunContext run(executor, {});
  const Ant& best = colony.run(run);
  ASSERT_TRUE(best.arrived());
  EXPECT_DOUBLE_EQ(best.cost, space.score(best.actions));
  ASSERT_EQ(colony.history().size(), 10U);
  EXPECT_DOUBLE_EQ(*colony.history().back().best_so_far, space.measure(best.actions).length_cells);
}

}  // namespace
}  // namespace alate
