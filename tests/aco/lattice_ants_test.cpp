#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "aco/deposit/dual_strategy.hpp"
#include "aco/heuristic/lattice_goal.hpp"
#include "aco/heuristic/terrain_factors.hpp"
#include "aco/local_search/none.hpp"
#include "aco/transition/lattice_table.hpp"
#include "aco/walk/lattice_walk.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

using Node = TerrainLattice::Node;
constexpr unsigned kAhead = 12;
constexpr unsigned kRow = TerrainLattice::kRow;

struct Flat {
  explicit Flat(const LatticeRules& rules = {}, Site site = test::flat_site())
      : world(std::move(site)),
        run(executor, {}),
        lattice(world, LatticeFrame(world, {.main_m = 1000, .side_m = 1000, .height_m = 200}),
                {.steps = {}, .rules = rules, .score = {.rule = TerrainScore::Rule::paper}}, run) {}

  World world;
  Executor executor;
  RunContext run;
  TerrainLattice lattice;
};

TEST(Q0Schedule, IsEquation15) {
  const Q0Schedule q0{.initial = 1, .is_constant = false};
  EXPECT_DOUBLE_EQ(q0(0, 500), 1);
  EXPECT_DOUBLE_EQ(q0(100, 500), 0.8);
  EXPECT_NEAR(q0(349, 500), 0.302, 1e-12);
  EXPECT_NEAR(q0(350, 500), 0.5, 1e-12);
  EXPECT_NEAR(q0(400, 500), 0.6, 1e-12);
  EXPECT_NEAR(q0(500, 500), 0.8, 1e-12);
  EXPECT_EQ(q0(5, 0), 1);
  EXPECT_EQ((Q0Schedule{.initial = 0.4})(300, 500), 0.4);
}

/// Step (1, 1, 0.2) km to 0.8 km above the sea, with (9, 9, 0.2) km left.
TEST(TerrainFactors, AreEquations12And13) {
  const double rest = std::sqrt(1 + 81 + 81 + 0.04);
  EXPECT_NEAR(terrain_factors({1, 1, 0.2}, {9, 9, 0.2}, 0.8, true), 1 / 1.8 / (std::sqrt(2.04) + rest), 1e-15);
  EXPECT_NEAR(terrain_factors({2, 1, 0.2}, {9, 9, 0.2}, 0.8, true), 1 / 1.8 / (std::sqrt(2.04) + rest), 1e-15);
  EXPECT_NEAR(terrain_factors({2, 1, 0.2}, {9, 9, 0.2}, 0.8, false), 1 / 1.8 / (std::sqrt(5.04) + rest), 1e-15);
}

TEST(TerrainFactors, FillTheTableInKmOrCells) {
  const Flat flat;
  const Node start = flat.lattice.frame().start();  // 10 km along x at 500 m
  const auto share = [&](const AlignedFloats& table, unsigned move) {
    return double{table[kRow * start + move]} / double{table[kRow * start + kAhead]};
  };
  const AlignedFloats km = terrain_factor_table(flat.lattice, {.beta = 2});
  const double ahead = 1 / 1.5 / (1 + std::sqrt(1 + 81.0));
  const double up = 1 / 1.7 / (std::sqrt(1.04) + std::sqrt(1 + 81.04));
  EXPECT_NEAR(share(km, kAhead + 1), std::pow(up / ahead, 2), 1e-6);
  const AlignedFloats cells = terrain_factor_table(flat.lattice, {.beta = 1, .unit = TerrainFactorRule::Unit::cells});
  const double ahead_cells = 1 / (1 + 2.5) / (1 + std::sqrt(1 + 81.0));
  const double up_cells = 1 / (1 + 3.5) / (std::numbers::sqrt2 + std::sqrt(1 + 81.0 + 1));
  EXPECT_NEAR(share(cells, kAhead + 1), up_cells / ahead_cells, 1e-6);
  EXPECT_EQ(km[kRow * start + 31], 0);
}

TEST(LatticeGoal, TablesKnowTheDistance) {
  const Flat flat;
  const Node start = flat.lattice.frame().start();
  const AlignedFloats distance = lattice_distance_table(flat.lattice, 2);
  EXPECT_NEAR(double{distance[kRow * start + kAhead]}, 1, 1e-6);
  EXPECT_NEAR(double{distance[kRow * start + kAhead + 5]}, 81.0 / 82, 1e-6);
  const AlignedFloats directed = lattice_directed_table(flat.lattice, 0.5);
  const double detour = std::numbers::sqrt2 + std::sqrt(82.0) - 10;  // the heights of nodes are alike
  EXPECT_NEAR(double{directed[kRow * start + kAhead + 5]} / double{directed[kRow * start + kAhead]},
              std::exp(-detour / 0.5), 1e-6);
}

struct Path {
  explicit Path(const TerrainLattice& lattice, LatticeCells::On on = LatticeCells::On::edges)
      : trail(LatticeCells(lattice.frame(), on), {.evaporation = 0, .unknown_decays = true}) {
    Node node = lattice.frame().start();
    for (std::size_t i = 0; i < lattice.walk_length(); ++i) {
      ant.actions.push_back(kAhead);
      ant.keys.push_back(trail.store().key(kRow * node + kAhead));
      node = lattice.frame().after(node, kAhead);
    }
    ant.cost = 50;
  }

  Trail<LatticeCells> trail;
  Ant ant;
};

TEST(DualStrategy, IsEquations16To19) {
  const Flat flat;
  Path path(flat.lattice);
  Ant best = path.ant;
  best.cost = 40;
  const std::vector<Ant> ants{path.ant};
  DualStrategy dual{.q = 100, .evaporation = 0.2};
  double tau = 1;
  for (std::uint64_t t = 1; t <= 3; ++t) {
    dual(path.trail, Harvest{ants, path.ant, best, t});
    tau = 0.8 * tau + 100 / (0.5 * 50 + 0.5 * 40);
    EXPECT_NEAR(double{path.trail.level(path.ant.keys[3])}, tau, 1e-5);
  }
  for (std::uint64_t t = 4; t <= 99; ++t) dual(path.trail, Harvest{ants, path.ant, best, t});
  EXPECT_NEAR(double{path.trail.level(path.ant.keys[3])}, 10, 1e-5);  // tau_max; the fixed point would be 11.1
  EXPECT_EQ(dual.lambda, 0.5);
  double lambda = 0.5;
  for (std::uint64_t t = 100; t <= 300; ++t) {
    dual(path.trail, Harvest{ants, path.ant, best, t});
    lambda *= t % 100 == 0 ? 0.9 : 1;
    EXPECT_NEAR(dual.lambda, lambda, 1e-15);
  }
  EXPECT_NEAR(dual.lambda, 0.5 * 0.729, 1e-15);
  EXPECT_EQ(path.trail.level(path.trail.store().key(kRow * flat.lattice.frame().start())), 1);  // untouched elsewhere
}

/// A trail above Delta / rho falls, and no lower than tau_min: nothing but the path evaporates.
TEST(DualStrategy, CanTakePheromoneAway) {
  const Flat flat;
  Path path(flat.lattice);
  DualStrategy dual{.q = 0.01, .evaporation = 0.5};
  const std::vector<Ant> ants{path.ant};
  for (std::uint64_t t = 1; t <= 20; ++t) dual(path.trail, Harvest{ants, path.ant, path.ant, t});
  EXPECT_NEAR(double{path.trail.level(path.ant.keys[0])}, 0.1, 1e-6);
}

unsigned choose(const LatticeTable& table, Node node, unsigned came, Stream& stream) {
  LatticeStands alone{.count = 1};
  alone.node[0] = node;
  alone.came[0] = came;
  alone.bits[0] = stream.bits();
  LatticeStands::Moves moves{};
  table.choose(alone, moves);
  return moves[0];
}

/// Shares of 40000 draws against the weights, the last move masking some of them.
TEST(LatticeTable, DrawsInProportionUnderTheMask) {
  LatticeRules rules;
  rules.limits.turn_rad = radians(60);
  const Flat flat(rules);
  const Node start = flat.lattice.frame().start();
  const Node node = flat.lattice.frame().after(start, 2);  // two cells to the right
  const AlignedFloats heuristic = terrain_factor_table(flat.lattice, {.beta = 3});
  LatticeTable table(flat.lattice, heuristic, {});
  const unsigned may = flat.lattice.moves().follows(2) & flat.lattice.moves().open(node);
  ASSERT_NE(may, flat.lattice.moves().open(node));
  double sum = 0;
  for (unsigned m = 0; m < 25; ++m) sum += ((may >> m) & 1U) != 0 ? double{heuristic[kRow * node + m]} : 0;
  std::array<int, 25> drawn{};
  constexpr int kDraws = 40000;
  Stream stream(1, 1, 1);
  for (int i = 0; i < kDraws; ++i) {
    const unsigned move = choose(table, node, 2, stream);
    ASSERT_LT(move, 25U);
    ++drawn[move];
  }
  for (unsigned m = 0; m < 25; ++m) {
    const double share = ((may >> m) & 1U) != 0 ? double{heuristic[kRow * node + m]} / sum : 0;
    EXPECT_NEAR(drawn[m], kDraws * share, 5 * std::sqrt(kDraws * share) + 1e-9) << m;
  }
}

TEST(LatticeTable, TakesTheHeaviestWithChanceQ0) {
  const Flat flat;
  const AlignedFloats heuristic = terrain_factor_table(flat.lattice, {.beta = 2});
  Path path(flat.lattice);
  LatticeTable table(flat.lattice, heuristic, {.q0 = {.initial = 1}});
  table.prepare(path.trail, 0, 0);
  Stream stream(1, 1, 1);
  const Node start = flat.lattice.frame().start();
  const unsigned low = choose(table, start, TerrainLattice::kFirst, stream);
  EXPECT_EQ(low, 10U);  // straight on, two levels down: eq. (12) wants to be low
  path.trail.add(path.ant.keys[0], 100);
  table.prepare(path.trail, 1, 0);
  EXPECT_EQ(choose(table, start, TerrainLattice::kFirst, stream), kAhead);
}

/// Who takes the best and who draws is told apart: nobody may take another one's move.
TEST(LatticeTable, ChoosesForEachAntAsIfItWereAlone) {
  const Flat flat;
  const LatticeFrame& frame = flat.lattice.frame();
  LatticeTable table(flat.lattice, terrain_factor_table(flat.lattice, {.beta = 2}), {.q0 = {.initial = 0.5}});
  Path path(flat.lattice);
  table.prepare(path.trail, 0, 0);
  for (std::size_t count = 0; count <= LatticeStands::kMost; ++count) {
    LatticeStands together{.count = count};
    Stream stream(3, count, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const auto came = static_cast<unsigned>(stream.below(25));
      together.node[i] = frame.after(frame.start(), came);
      together.came[i] = came;
      together.bits[i] = stream.bits();
    }
    LatticeStands::Moves moves{};
    table.choose(together, moves);
    for (std::size_t i = 0; i < count; ++i) {
      LatticeStands alone{.count = 1};
      alone.node[0] = together.node[i];
      alone.came[0] = together.came[i];
      alone.bits[0] = together.bits[i];
      LatticeStands::Moves its{};
      table.choose(alone, its);
      EXPECT_EQ(moves[i], its[0]) << i << " of " << count;
    }
  }
}

TEST(LatticeTable, IsTheSameForTrailsOnNodes) {
  const Flat flat;
  const AlignedFloats heuristic = terrain_factor_table(flat.lattice, {.beta = 2});
  Path path(flat.lattice, LatticeCells::On::nodes);
  LatticeTable table(flat.lattice, heuristic, {.q0 = {.initial = 1}});
  const LatticeFrame& frame = flat.lattice.frame();
  const Node ahead = frame.after(frame.after(frame.start(), kAhead), kAhead);
  path.trail.add(path.ant.keys[1], 100);
  table.prepare(path.trail, 0, 0);
  Stream stream(1, 1, 1);
  for (const unsigned first : {7U, 12U, 17U}) {  // from the right, straight on, from the left
    const Node node = frame.after(frame.start(), first);
    EXPECT_EQ(frame.after(node, choose(table, node, first, stream)), ahead) << first;
  }
}

struct NoDepositPolicy {
  template <class Trail>
  void operator()(Trail& /*trail*/, const Harvest& /*harvest*/) const {}
};

LatticeTally walk_once(const LatticeRules& rules, std::vector<Ant>& ants) {
  Flat flat(rules, test::simple_site());
  using Policies = LatticePolicies<LatticeTable, NoDepositPolicy, NoLocalSearch>;
  Path path(flat.lattice);
  LatticeTally tally;
  Policies policies{LatticeTable(flat.lattice, terrain_factor_table(flat.lattice, {}), {}), path.trail, {}, {}};
  LatticeWalk<Policies> walk(flat.lattice, {.ants = ants.size(), .tally = &tally});
  for (std::size_t a = 0; a < ants.size(); ++a) ants[a].index = a;
  walk(policies, ants, Ant{}, flat.run);
  for (const Ant& ant : ants) {
    if (!ant.arrived()) continue;
    const LatticeFlight flight = flat.lattice.judge(*flat.lattice.edges(ant.actions));
    EXPECT_EQ(flight.score, ant.cost);
    EXPECT_EQ(flight.is_route, ant.is_route);
  }
  return tally;
}

TEST(LatticeWalk, CountsDeadEndsUnlessTheyArePruned) {
  std::vector<Ant> ants(100);
  const LatticeTally kept = walk_once({.any_join = false, .prunes = false}, ants);
  EXPECT_EQ(kept.dead_ends,
            static_cast<std::uint64_t>(std::ranges::count_if(ants, [](const Ant& a) { return !a.arrived(); })));
  EXPECT_GT(kept.dead_ends, 0U);
  EXPECT_EQ(walk_once({.prunes = true}, ants).dead_ends, 0U);
}

TEST(LatticeWalk, NodesAloneLetLegsHitTheGround) {
  std::vector<Ant> ants(200);
  const LatticeTally tally = walk_once({.whole_legs = false}, ants);
  EXPECT_GT(tally.faults.collision, 0U);
  EXPECT_TRUE(std::ranges::any_of(ants, [](const Ant& ant) { return ant.arrived() && !ant.is_route; }));
  EXPECT_EQ(walk_once({.whole_legs = true}, ants).faults.collision, 0U);
}

}  // namespace
}  // namespace alate
