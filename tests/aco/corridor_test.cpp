#include "aco/local_search/corridor.hpp"

#include <gtest/gtest.h>

#include "support/terrain_sites.hpp"

namespace alate {
namespace {

constexpr std::uint32_t kAhead = 12;

struct Flat {
  explicit Flat(const LatticeLimits& limits = {}, const TerrainScore& score = {})
      : lattice(world, LatticeFrame(world, {.main_m = 1000, .side_m = 1000, .height_m = 200}),
                {.steps = {}, .rules = {.limits = limits}, .score = score}, run) {}

  World world{test::flat_site()};
  Executor executor;
  RunContext run{executor, {}};
  TerrainLattice lattice;
};

double score_of(const TerrainLattice& lattice, const std::vector<std::uint32_t>& moves) {
  const auto edges = lattice.edges(moves);
  return edges ? lattice.judge(*edges).score : kInfinity;
}

/// Three cells aside and a level up, and back again: the straight line is found from corridor to corridor.
TEST(Corridor, StraightensADetour) {
  Flat flat;
  std::vector<std::uint32_t> moves{17, 18, 17, 12, 12, 12, 7, 6, 7};
  ASSERT_LT(score_of(flat.lattice, moves), kInfinity);
  Corridor corridor;
  EXPECT_TRUE(corridor(flat.lattice, moves, flat.run));
  EXPECT_EQ(moves, std::vector<std::uint32_t>(9, kAhead));
  EXPECT_FALSE(corridor(flat.lattice, moves, flat.run));
}

/// Turns cost, and in the second case are limited.
TEST(Corridor, LeavesNoBetterBendUnderTurnLimits) {
  for (const double turn_deg : {180.0, 46.0}) {
    Flat flat({.turn_rad = radians(turn_deg)}, {.rule = TerrainScore::Rule::paper, .turn = 5});
    std::vector<std::uint32_t> moves{17, 17, 17, 12, 12, 12, 7, 7, 7};
    ASSERT_LT(score_of(flat.lattice, moves), kInfinity);
    const double before = score_of(flat.lattice, moves);
    Corridor corridor;
    corridor(flat.lattice, moves, flat.run);
    const double after = score_of(flat.lattice, moves);
    EXPECT_LT(after, before);
    // No single bend of the result within its corridor is better.
    for (std::size_t i = 0; i + 1 < moves.size(); ++i) {
      for (const int bend : {-6, -5, -4, -1, 1, 4, 5, 6}) {
        std::vector<std::uint32_t> bent = moves;
        bent[i] = static_cast<std::uint32_t>(static_cast<int>(bent[i]) + bend);
        bent[i + 1] = static_cast<std::uint32_t>(static_cast<int>(bent[i + 1]) - bend);
        if (bent[i] >= 25 || bent[i + 1] >= 25) continue;
        const Vec3 a = flat.lattice.frame().shifts()[bent[i]].leg + flat.lattice.frame().shifts()[bent[i + 1]].leg;
        const Vec3 b = flat.lattice.frame().shifts()[moves[i]].leg + flat.lattice.frame().shifts()[moves[i + 1]].leg;
        if ((a - b).norm() > 1) continue;  // wrapped round to another column
        EXPECT_GE(score_of(flat.lattice, bent), after * (1 - 1e-9));
      }
    }
  }
}

}  // namespace
}  // namespace alate
