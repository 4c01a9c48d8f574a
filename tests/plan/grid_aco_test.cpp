#include <gtest/gtest.h>

#include <numbers>

#include "alate/check/check.hpp"
#include "support/fly.hpp"
#include "support/grid_sites.hpp"

namespace alate {
namespace {

using test::drawn_grid;
using test::fly;
using test::grid_site;

/// Mean gap of `improved` to the shortest way over drawn maps that have one.
double mean_gap(int side, int maps, std::uint64_t iterations) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t seed = 1; count < maps; ++seed) {
    const HeightGrid grid = drawn_grid(side, seed);
    const double least = test::shortest_length(test::corner_space(grid, std::numbers::sqrt2));
    if (!(least < kInfinity)) continue;
    const Plan plan = fly(grid_site(grid), {.name = "grid-aco"}, {.iterations = iterations, .seed = seed});
    EXPECT_FALSE(plan.route.empty());
    EXPECT_GE(plan.cost, least * (1 - 1e-12));
    sum += plan.cost / least - 1;
    ++count;
  }
  return sum / count;
}

TEST(GridAco, ImprovedComesNearTheShortestWay) {
  EXPECT_LT(mean_gap(30, 40, 200), 0.01);
  EXPECT_LT(mean_gap(100, 10, 200), 0.03);
}

TEST(GridAco, ProvesThatThereIsNoWayAndSaysWhereItEnds) {
  const Site site = grid_site(test::grid_of({"....", "####", "....", "...."}));
  const Plan plan = fly(site, {.name = "grid-aco"});
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_TRUE(plan.route.empty());
  EXPECT_NE(plan.why.find("[3, 2] is the nearest to the goal, 2.0 cells"), std::string::npos) << plan.why;
}

TEST(GridAco, StaysWhereItIs) {
  Site site = grid_site(drawn_grid(5, 1, 0));
  site.mission.goal = site.mission.start;
  const Plan plan = fly(site, {.name = "grid-aco"});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_EQ(plan.route.states.size(), 1U);
}

TEST(GridAco, TellsLengthsInMetresAndTheLastChange) {
  HeightGrid grid = drawn_grid(30, 2);
  grid.cell_m = 50;
  const Plan plan = fly(grid_site(grid), {.name = "grid-aco", .preset = "mmas"}, {.iterations = 30});
  ASSERT_EQ(plan.history.size(), 30U);
  EXPECT_NEAR(*plan.history.back().best_so_far, plan.cost, 1e-9 * plan.cost);
  const std::uint64_t last = plan.counters.at("last_change");
  ASSERT_GE(last, 1U);
  EXPECT_EQ(plan.history[last - 1].best_so_far, plan.history.back().best_so_far);
  if (last > 1) {
    EXPECT_NE(plan.history[last - 2].best_so_far, plan.history.back().best_so_far);
  }
}

/// The colony and the check measure alike; ant 0 repeats the best route, so its score never rises.
TEST(GridAco, TellsTheMeasuresOfTheBestRoute) {
  const Site site = grid_site(drawn_grid(30, 2));
  const Plan plan = fly(site, {.name = "grid-aco", .preset = "li2019", .settings = {{"diagonal", "sqrt2", "test"}}},
                        {.iterations = 12});
  const GridMeasures check = *measure(site, plan.route).grid;
  const GridMeasures told = plan.history.back().grid->best;
  EXPECT_NEAR(told.length_cells, check.length_cells, 1e-9);
  EXPECT_NEAR(told.height_deviation_m, check.height_deviation_m, 1e-9);
  EXPECT_EQ(told.turns, check.turns);
  double before = kInfinity;
  for (const IterationStats& stats : plan.history) {
    if (!stats.grid) continue;
    EXPECT_LE(composite_index(stats.grid->best), before);
    before = composite_index(stats.grid->best);
    EXPECT_GE(*stats.grid->mean_score, before * (1 - 1e-12));
  }
  EXPECT_LT(before, kInfinity);
}

/// Both have the same parameters, so only mu may tell them apart.
TEST(GridAco, YinDiffersFromLiByMuAlone) {
  const Site site = grid_site(drawn_grid(30, 2));
  const Plan li = fly(site, {.name = "grid-aco", .preset = "li2019"}, {.iterations = 5});
  const Plan yin = fly(site, {.name = "grid-aco", .preset = "yin2021"}, {.iterations = 5});
  const Plan without =
      fly(site, {.name = "grid-aco", .preset = "yin2021", .settings = {{"mu_power", "0", "test"}}}, {.iterations = 5});
  EXPECT_EQ(li.history.back().mean, without.history.back().mean);
  EXPECT_NE(li.history.back().mean, yin.history.back().mean);
}

std::string refusal(const Site& site) {
  const World world(site);
  return builtin_planners().find("grid-aco")->refuses(Problem(world));
}

TEST(GridAco, RefusesWhatItCannotServe) {
  const Site site = grid_site(drawn_grid(10, 1, 0));
  EXPECT_EQ(refusal(site), "");
  Site without = site;
  without.grid.reset();
  EXPECT_NE(refusal(without).find("add grid"), std::string::npos);
  Site beside = site;
  beside.mission.goal.x() += 0.1;
  EXPECT_NE(refusal(beside).find("middle"), std::string::npos);
  Site outside = site;
  outside.mission.goal = {-1, -1, 0};
  EXPECT_NE(refusal(outside).find("middle"), std::string::npos);
  Site turning = site;
  turning.vehicle.turn_radius_m = 1;
  EXPECT_NE(refusal(turning).find("corners"), std::string::npos);
  Site threatened = site;
  threatened.threats.push_back({.name = "radar", .center = {5, 5, 0}, .radius_m = 2});
  EXPECT_NE(refusal(threatened).find("threats"), std::string::npos);
}

TEST(GridAco, OnlyPlannersOnGridsServeThem) {
  Site site = grid_site(drawn_grid(10, 1, 0));
  site.vehicle = {.step_m = 1, .roll_rad = {0}, .pitch_rad = {0}, .yaw_rad = {0}};
  const World world(site);
  for (const PlannerEntry& entry : builtin_planners().entries())
    EXPECT_EQ(entry.refuses(Problem(world)).empty(), entry.can.space == "height grid") << entry.name;
}

}  // namespace
}  // namespace alate
