// Searches over a terrain lattice, against dynamic programming and against each other.
#include <gtest/gtest.h>

#include "search/lattice_astar.hpp"
#include "search/lattice_theta.hpp"
#include "space/objective.hpp"
#include "space/straight_limits.hpp"
#include "space/sure_leg.hpp"
#include "support/hand_made_sites.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

struct Made {
  explicit Made(const Site& site, LatticeOptions options = {})
      : world(site), run(executor, {}), lattice(world, LatticeFrame(world, options.steps), options, run) {}

  LatticeWay astar() { return lattice_astar(lattice, run); }
  LatticeWay theta() { return lattice_theta(world, lattice, run); }
  double cost(const std::vector<Vec3>& places) const {
    const Objective objective(world);
    double sum = 0;
    for (std::size_t i = 1; i < places.size(); ++i) sum += objective.leg_cost({places[i - 1], places[i]});
    return sum;
  }

  World world;
  Executor executor;
  RunContext run;
  TerrainLattice lattice;
};

double length(const std::vector<Vec3>& places) {
  double sum = 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += (places[i] - places[i - 1]).norm();
  return sum;
}

/// Hills, an aircraft that needs room for its turns, and a price on climbs and threats.
Site busy_site() {
  Site site = test::simple_site();
  site.vehicle = {.turn_radius_m = 900, .climb_rad = radians(12), .descent_rad = radians(12)};
  site.scenario.objective = {.model = CostModel::physical, .length = 1, .threat = 20, .climb = 3};
  site.threats.push_back(
      {.name = "radar", .center = {25000, 25000, 800}, .radius_m = 9000, .level = 0.7, .core_m = 2000});
  return site;
}

std::vector<std::pair<std::string, Made*>> cases() {
  static Made plain(test::simple_site());
  static Made busy(busy_site());
  static Made gap(test::ridge_site(), {.steps = {.main = MainDirection::line}});
  static Made paper(test::simple_site(), {.rules = {.limits = {.turn_rad = radians(60)}},
                                          .score = {.rule = TerrainScore::Rule::paper, .height = 3, .turn = 2}});
  return {{"plain", &plain}, {"busy", &busy}, {"gap", &gap}, {"paper", &paper}};
}

TEST(LatticeAStar, FindsWhatDynamicProgrammingFinds) {
  for (const auto& [name, made] : cases()) {
    const auto optimum = lattice_optimum(made->lattice);
    const LatticeWay way = made->astar();
    ASSERT_EQ(way.best.has_value(), optimum.has_value()) << name;
    ASSERT_TRUE(way.best) << name;
    EXPECT_NEAR(way.best->score, optimum->score, 1e-9 * optimum->score) << name;
    EXPECT_EQ(way.best->places.size(), optimum->places.size()) << name;
    if (made->lattice.score().rule().is_papers()) continue;
    EXPECT_NEAR(made->cost(way.best->places), way.best->score, 1e-6 * way.best->score) << name;
  }
}

/// The paper's score of a route below the sea falls with every leg; the bound must fall with it.
TEST(LatticeAStar, IsExactWhereHeightsAreBelowZero) {
  Site site = test::simple_site();
  site.mission.start.z() = site.mission.goal.z() = -1500;
  site.band.ceiling_amsl_m = {};
  site.ground = PeakGround{.peaks = {{.center = {16000, 17000}, .height_m = -3000, .slope_m = {9000, 8000}}},
                           .maximum = false,
                           .area = {.min = {0, 0}, .max = {50000, 50000}}};
  site.mission.start = {16000, 0, 300};
  site.mission.goal = {16000, 40000, 300};
  Made made(site, {.score = {.rule = TerrainScore::Rule::paper, .height = 2, .turn = 0.1}});
  const auto optimum = lattice_optimum(made.lattice);
  ASSERT_TRUE(optimum);
  EXPECT_LT(made.lattice.score().least_of_end(), 0);
  EXPECT_NEAR(made.astar().best->score, optimum->score, 1e-9);
}

/// A radar makes the short way dear: the cheapest way is longer than the range, so a dearer one is the best.
TEST(LatticeAStar, KeepsTheRangeThatDynamicProgrammingDoesNotSee) {
  Site site = test::flat_site();
  site.scenario.objective = {.model = CostModel::physical, .length = 1, .threat = 30};
  site.threats.push_back({.name = "radar", .center = {10000, 10000, 500}, .radius_m = 3000, .level = 1});
  const LatticeSteps steps{.main_m = 1000, .side_m = 1000, .height_m = 200, .window_height = 1};
  Made free(site, {.steps = steps});
  const LatticeWay around = free.astar();
  ASSERT_TRUE(around.best);
  ASSERT_GT(length(around.best->places), 12000);
  site.vehicle.range_m = 11900;
  Made limited(site, {.steps = steps});
  const LatticeWay within = limited.astar();
  ASSERT_TRUE(within.best);
  EXPECT_LE(length(within.best->places), 11900);
  EXPECT_GT(within.best->score, around.best->score);
  site.vehicle.range_m = 10001;  // straight through the radar, and nothing else
  Made straight(site, {.steps = steps});
  const LatticeWay through = straight.astar();
  ASSERT_TRUE(through.best);
  EXPECT_NEAR(length(through.best->places), 10000, 1e-6);
  EXPECT_LT(within.best->score, through.best->score);
  site.vehicle.range_m = 9999;
  Made none(site, {.steps = steps});
  const LatticeWay no_way = none.astar();
  EXPECT_TRUE(no_way.finished);
  EXPECT_FALSE(no_way.best);
}

TEST(LatticeAStar, ExpandsFewerNodesThanThereAre) {
  Made made(test::simple_site());
  EXPECT_LT(made.astar().expansions, made.lattice.frame().nodes() / 2);
}

TEST(LatticeTheta, FliesLegsThatKeepEveryLimit) {
  for (const auto& [name, made] : cases()) {
    if (made->lattice.score().rule().is_papers()) continue;
    const LatticeWay way = made->theta();
    ASSERT_TRUE(way.best) << name;
    const StraightLimits limits(made->world.site());
    const std::vector<Vec3>& places = way.best->places;
    EXPECT_EQ(places.front(), made->world.site().mission.start);
    EXPECT_EQ(places.back(), made->world.site().mission.goal);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Vec3 leg = places[i] - places[i - 1];
      EXPECT_TRUE(is_surely_free(made->world, {places[i - 1], places[i]})) << name << ' ' << i;
      EXPECT_TRUE(limits.allows(leg)) << name << ' ' << i;
      EXPECT_TRUE(i == 1 ? limits.allows_first(leg) : limits.allows_corner(places[i - 1] - places[i - 2], leg)) << name;
    }
    EXPECT_NEAR(made->cost(places), way.best->score, 1e-9 * way.best->score) << name;
  }
}

/// Over a plain the straight line is a single leg, whatever the lattice's directions.
TEST(LatticeTheta, FliesStraightOverAPlain) {
  Site site = test::flat_site();
  site.mission.goal += Vec3(3100, 4700, 130);
  Made made(site, {.steps = {.main = MainDirection::x, .main_m = 1000, .side_m = 1000, .height_m = 200}});
  const LatticeWay way = made.theta();
  ASSERT_TRUE(way.best);
  EXPECT_EQ(way.best->places.size(), 2U);
  EXPECT_LT(way.best->score, made.astar().best->score);
}

TEST(LatticeTheta, IsShorterThanMovesOverHills) {
  Made made(test::simple_site());
  EXPECT_LT(made.theta().best->score, made.astar().best->score * 0.999);
}

TEST(LatticeSearches, EndWithoutAWayWhereAWallIsClosed) {
  Made made(test::ridge_site(false));
  for (const LatticeWay& way : {made.astar(), made.theta()}) {
    EXPECT_TRUE(way.finished);
    EXPECT_FALSE(way.best);
  }
}

}  // namespace
}  // namespace alate
