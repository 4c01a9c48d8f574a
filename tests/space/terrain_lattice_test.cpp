#include "space/terrain_lattice.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "alate/check/check.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

using test::flat_site;
using test::simple_site;

constexpr std::uint32_t kAhead = 12;  // neither aside nor up or down

struct Made {
  explicit Made(const Site& site, LatticeOptions options = {})
      : world(site), run(executor, {}), lattice(world, LatticeFrame(world, options.steps), options, run) {}

  LatticeFlight judge(const std::vector<std::uint32_t>& moves) const { return lattice.judge(*lattice.edges(moves)); }

  World world;
  Executor executor;
  RunContext run;
  TerrainLattice lattice;
};

LatticeOptions papers_score() { return {.steps = {}, .rules = {}, .score = {.rule = TerrainScore::Rule::paper}}; }

TEST(LatticeFrame, IsThatOfThePaperOnItsMap) {
  const World world(simple_site());
  const LatticeFrame frame(world, {});
  EXPECT_EQ(frame.fault(), "");
  EXPECT_EQ(frame.planes(), 50);
  EXPECT_EQ(frame.moves(), 25U);
  EXPECT_NEAR((frame.steps_m() - Vec3(1000, 1000, 200)).norm(), 0, 1e-9);
  EXPECT_EQ(frame.columns(), 51);
  EXPECT_NEAR((frame.position(frame.start()) - Vec3(0, 0, 1000)).norm(), 0, 1e-9);
  const LatticeFrame::Node next = frame.after(frame.start(), kAhead + 5);
  EXPECT_NEAR((frame.position(next) - Vec3(1000, 1000, 1000)).norm(), 0, 1e-9);
}

TEST(LatticeFrame, NumbersNodesBackAndForth) {
  const World world(simple_site());
  const LatticeFrame frame(world, {});
  for (LatticeFrame::Node node = 0; node < frame.nodes(); node += 7) EXPECT_EQ(frame.node(frame.place(node)), node);
}

TEST(LatticeFrame, AutomaticallyTakesTheLongerSide) {
  Site site = simple_site();
  site.mission.goal = {10000, 50000, 1000};
  const LatticeFrame frame(World(site), {});
  EXPECT_NEAR(frame.position(frame.after(frame.start(), kAhead)).y(), 1000, 1e-9);
  const LatticeFrame across(World(site), {.main = MainDirection::x});
  EXPECT_NEAR(across.position(across.after(across.start(), kAhead)).x(), 200, 1e-9);
}

TEST(LatticeFrame, SaysWhyThereIsNone) {
  Site site = simple_site();
  EXPECT_NE(LatticeFrame(World(site), {.main_m = 0.001}).fault().find("longer steps"), std::string::npos);
  EXPECT_NE(LatticeFrame(World(site), {.side_m = 0.001}).fault().find("longer steps"), std::string::npos);
  site.mission.goal = {0, 50000, 1000};
  EXPECT_NE(LatticeFrame(World(site), {.main = MainDirection::x}).fault().find("same x"), std::string::npos);
}

/// Every open move by the decision of World on its own leg, and no other is free.
TEST(LatticeMoves, AreThoseThatWorldCallsFree) {
  Site site = simple_site();
  site.mission.goal = {20000, 20000, 1000};
  site.threats.push_back({.name = "core", .center = {9000, 8000, 1000}, .radius_m = 3000, .core_m = 1500});
  const Made made(site, {.steps = {.main_m = 1000}, .rules = {.prunes = false}});
  const LatticeFrame& frame = made.lattice.frame();
  int open = 0;
  int closed = 0;
  for (LatticeFrame::Node node = 0; node < frame.nodes(); ++node) {
    if (!made.lattice.moves().is_reached(node)) continue;
    for (unsigned m = 0; m < frame.moves(); ++m) {
      if (!frame.stays(frame.place(node), m)) continue;
      const Segment leg{frame.position(node), frame.position(frame.after(node, m))};
      const bool is_open = ((made.lattice.moves().open(node) >> m) & 1U) != 0;
      ASSERT_EQ(is_open, made.world.is_free(leg)) << node << ' ' << m;
      ++(is_open ? open : closed);
    }
  }
  EXPECT_GT(open, 1000);
  EXPECT_GT(closed, 100);
}

TEST(LatticeMoves, PrunedNoneLeadsIntoADeadEnd) {
  const Made made(simple_site());
  const LatticeFrame& frame = made.lattice.frame();
  EXPECT_TRUE(made.lattice.moves().has_way());
  const LatticeFrame::Node last = frame.nodes() - frame.plane_size();
  for (LatticeFrame::Node node = 0; node < last; ++node)
    for (unsigned open = made.lattice.moves().open(node); open != 0; open &= open - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(open));
      const LatticeFrame::Node to = frame.after(node, move);
      ASSERT_NE(to < last ? made.lattice.moves().open(to) : made.lattice.moves().joins(to), 0U);
    }
}

TEST(LatticeMoves, KeepTheAircraftsLimitsAndTheConstraints) {
  Site site = flat_site();
  site.vehicle = {.turn_radius_m = 600, .climb_rad = radians(12), .descent_rad = radians(25)};
  const LatticeSteps paper{.main_m = 1000, .side_m = 1000, .height_m = 200};
  const Made made(site, {.steps = paper, .rules = {.limits = {.pitch_rad = radians(20)}, .prunes = false}});
  const unsigned open = made.lattice.moves().open(made.lattice.frame().start());
  // 200 m up on 1000 m is 11.3 degrees, 400 m 21.8: too steep to climb, and for eq. (5) both ways; aside it is less.
  EXPECT_EQ((open >> 10U) & 31U, 0b01110U);
  EXPECT_EQ(open & 31U, 0b11111U);  // 400 m on 2236 m is 10.1 degrees
  // A radius of 600 m on legs of 1000 m allows a turn of 2 atan(500 / 600), 79.6 degrees: 45 but not 108.
  const unsigned after_left = made.lattice.moves().follows(2);
  EXPECT_NE(after_left & (1U << kAhead), 0U);
  EXPECT_EQ(after_left & (1U << 22U), 0U);
}

TEST(TerrainLattice, JudgesAStraightRouteByHand) {
  LatticeOptions options = papers_score();
  options.steps = {.main_m = 1000, .side_m = 1000, .height_m = 200};
  const Made made(flat_site(), options);  // 10 km along x at 500 m
  const std::vector<std::uint32_t> straight(9, kAhead);
  const LatticeFlight flight = made.judge(straight);
  EXPECT_TRUE(flight.is_route);
  EXPECT_NEAR(flight.length_m, 10000, 1e-9);
  EXPECT_NEAR(flight.score, 10 + 10 * 0.5, 1e-6);
  std::vector<std::uint32_t> bent = straight;
  bent[0] = kAhead + 5;  // 45 degrees to the left, back again at the next
  bent[1] = kAhead - 5;
  EXPECT_NEAR(made.judge(bent).score, 8 + 2 * std::sqrt(2.0) + 5 + kPi / 2 + kPi / 4, 1e-6);
  EXPECT_FALSE(made.lattice.fly(std::vector<std::uint32_t>(8, kAhead)));
  EXPECT_EQ(made.lattice.places(straight).back(), made.world.site().mission.goal);
}

TEST(TerrainLattice, PenaltiesCountWhatFiltersForbid) {
  LatticeOptions options = papers_score();
  options.steps = {.main_m = 1000, .side_m = 1000, .height_m = 200};
  options.rules.limits = {.length_m = 9000, .height_amsl_m = 600, .pitch_rad = radians(5), .turn_rad = radians(60)};
  options.rules.filters = false;
  options.score.penalty = 100;
  const Made made(flat_site(), options);
  std::vector<std::uint32_t> moves(9, kAhead);
  moves[0] = kAhead + 6;  // up by 200 m: too steep and too high
  moves[1] = kAhead - 6;  // 90 degrees, too steep
  const LatticeFlight flight = made.judge(moves);
  EXPECT_TRUE(flight.is_route);
  EXPECT_EQ(flight.faults.pitch, 2U);
  EXPECT_EQ(flight.faults.height, 1U);
  EXPECT_EQ(flight.faults.turn, 1U);
  EXPECT_EQ(flight.faults.length, 1U);
  EXPECT_GT(flight.score, 500);
  options.rules.filters = true;
  const Made filtered(flat_site(), options);
  EXPECT_FALSE(filtered.lattice.fly(moves));
  EXPECT_FALSE(filtered.lattice.fly(std::vector<std::uint32_t>(9, kAhead)));  // longer than 9 km
}

TEST(TerrainLattice, CostsWhatTheRouteMeasures) {
  Site site = simple_site();
  site.threats.push_back({.name = "radar", .center = {25000, 25000, 500}, .radius_m = 9000, .level = 0.7});
  const Made made(site);
  std::vector<std::uint32_t> moves;
  LatticeFrame::Node node = made.lattice.frame().start();
  while (moves.size() < made.lattice.walk_length()) {  // the last open move of every node
    moves.push_back(static_cast<std::uint32_t>(std::bit_width(made.lattice.moves().open(node)) - 1));
    node = made.lattice.frame().after(node, moves.back());
  }
  const auto flight = made.lattice.fly(moves);
  ASSERT_TRUE(flight);
  Route route;
  for (const Vec3& place : made.lattice.places(moves))
    route.states.push_back({.position = place, .leg = route.empty() ? LegKind::start : LegKind::straight});
  EXPECT_TRUE(check(site, route).ok());
  const double measured = measure(site, route).cost;
  EXPECT_NEAR(flight->cost, measured, 1e-6 * measured);
}

}  // namespace
}  // namespace alate
