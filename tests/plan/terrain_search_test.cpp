// A* and Theta* over terrain as planners: what they claim, what they refuse, one name for several spaces.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "support/fly.hpp"
#include "support/grid_sites.hpp"
#include "support/hand_made_sites.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

using test::fly;

std::string refusal(const char* planner, const Site& site) {
  const World world(site);
  return builtin_planners().find(planner)->refuses(Problem(world));
}

TEST(TerrainSearch, ClaimsNoMoreThanTheLattice) {
  const Plan plan = fly(test::simple_site(), {.name = "astar"});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_NE(plan.why.find("best string of moves"), std::string::npos);
  EXPECT_LT(plan.lower_bound, plan.cost);
  EXPECT_TRUE(check(test::simple_site(), plan.route).ok());
}

/// Ants on the same lattice can do no better, and the routes of others that leave it are cheaper.
TEST(TerrainSearch, IsTheBestOnTheLatticeOfTheAnts) {
  for (const Site& site : {test::simple_site(), test::ridge_site()}) {
    const Plan moves = fly(site, {.name = "astar"});
    const Plan ants = fly(site, {.name = "terrain-aco", .settings = {{"polish", "none", "test"}}}, {.iterations = 100});
    const Plan taut = fly(site, {.name = "astar", .settings = {{"polish", "taut", "test"}}});
    const Plan theta = fly(site, {.name = "theta-star"});
    ASSERT_EQ(moves.outcome, Outcome::feasible) << moves.why;
    EXPECT_LE(moves.cost, ants.cost * (1 + 1e-9));
    EXPECT_LE(taut.cost, moves.cost);
    EXPECT_LE(theta.cost, moves.cost * (1 + 1e-9));
  }
}

TEST(TerrainSearch, FindsTheBestFitnessOfThePaper) {
  const Site site = test::simple_site();
  const std::vector<ParamSetting> papers{{"fitness", "paper", "test"},     {"main_direction", "auto", "test"},
                                         {"join", "any", "test"},          {"turn_max_deg", "60", "test"},
                                         {"safe_height_m", "100", "test"}, {"pitch_max_deg", "45", "test"}};
  const Plan ants = fly(site, {.name = "terrain-aco", .preset = "mai2023"}, {.iterations = 60});
  const Plan by_fitness = fly(site, {.name = "astar", .settings = papers});
  const Plan by_length = fly(site, {.name = "astar"});
  ASSERT_EQ(by_fitness.outcome, Outcome::feasible) << by_fitness.why;
  EXPECT_GT(by_fitness.cost, by_length.cost);
  EXPECT_NE(by_fitness.cost, ants.cost);
}

TEST(TerrainSearch, SaysWhereAClosedWallEndsTheLattice) {
  for (const char* planner : {"astar", "theta-star"}) {
    const Plan plan = fly(test::ridge_site(false), {.name = planner});
    EXPECT_EQ(plan.outcome, Outcome::none_found) << "the air between the nodes was not asked";
    EXPECT_NE(plan.why.find("at 3520 m along the straight line"), std::string::npos) << plan.why;
  }
}

/// Moves lead to the goal, but none of them is within reach of the tanks.
TEST(TerrainSearch, SaysThatNoStringKeepsTheRange) {
  Site site = test::ridge_site();
  site.vehicle.range_m = 8100;
  const Plan plan = fly(site, {.name = "astar"});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_NE(plan.why.find("no string of them"), std::string::npos) << plan.why;
}

TEST(TerrainSearch, OneNameServesSeveralSpaces) {
  const Site grid = test::grid_site(test::drawn_grid(10, 1, 0));
  EXPECT_EQ(refusal("astar", grid), "");
  EXPECT_EQ(refusal("astar", test::simple_site()), "");
  EXPECT_EQ(fly(grid, {.name = "astar"}).outcome, Outcome::optimal);
  EXPECT_NE(refusal("astar", test::open_air_site()).find("add grid"), std::string::npos);
  Site nodes = test::simple_site();
  nodes.scenario.objective.model = CostModel::konatowski2019;
  EXPECT_NE(refusal("astar", nodes).find("physical"), std::string::npos);
  EXPECT_NE(refusal("jps", test::simple_site()).find("take astar"), std::string::npos);
}

TEST(TerrainSearch, LeavesTheAutomaticChoiceToAnts) {
  const World world(test::simple_site());
  EXPECT_EQ(choose_planner(builtin_planners(), Problem(world), {}).name, "terrain-aco");
}

}  // namespace
}  // namespace alate
