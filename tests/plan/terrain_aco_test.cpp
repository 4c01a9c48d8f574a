#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "support/fly.hpp"
#include "support/grid_sites.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

using test::fly;

Site example(const std::string& name) {
  return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/mai2023/" + name + ".yaml"));
}

/// Values of the peaks of tables 1 and 2, worked out by hand from eq. (1): sum, no factor 1/2.
TEST(Mai2023, ExamplesHaveThePapersPeaks) {
  const Site simple = example("simple");
  EXPECT_NEAR(*simple.ground_height({30000, 9000}), 671.173, 1e-3);
  EXPECT_NEAR(*simple.ground_height({25000, 25000}), 126.587, 1e-3);
  EXPECT_NEAR(*simple.ground_height({16000, 17000}), 1640, 1e-3);
  const Site medium = example("medium");
  EXPECT_NEAR(*medium.ground_height({21000, 25000}), 2204.757, 1e-3);
  EXPECT_NEAR(*medium.ground_height({33000, 15000}), 2311.914, 1e-3);
  EXPECT_NEAR(*medium.ground_height({25000, 25000}), 1023.326, 1e-3);
}

class Mai2023Scenes : public testing::TestWithParam<const char*> {};

TEST_P(Mai2023Scenes, EveryPresetFindsARouteThatPassesCheck) {
  const Site site = example(GetParam());
  for (const char* preset : {"improved", "mai2023", "aco"}) {
    const Plan plan = fly(site, {.name = "terrain-aco", .preset = preset}, {.iterations = 100});
    ASSERT_EQ(plan.outcome, Outcome::feasible) << preset << ": " << plan.why;
    EXPECT_TRUE(check(site, plan.route).ok()) << preset;
    EXPECT_GE(plan.cost, plan.lower_bound);
  }
}

TEST_P(Mai2023Scenes, TrailsLeadToBetterRoutesThanChance) {
  const Site site = example(GetParam());
  const auto fitness = [&](std::vector<ParamSetting> settings) {
    const PlannerRequest request{.name = "terrain-aco", .preset = "mai2023", .settings = std::move(settings)};
    return *fly(site, request).history.back().best_so_far;
  };
  EXPECT_LT(fitness({}), fitness({{"alpha", "0", "test"}}));
}

INSTANTIATE_TEST_SUITE_P(All, Mai2023Scenes, testing::Values("simple", "medium", "ours"));

TEST(TerrainAco, ReadingsOfThePaperThatChangeTheSearchDo) {
  const Site site = test::simple_site();
  const auto best = [&](std::vector<ParamSetting> settings) {
    const PlannerRequest request{.name = "terrain-aco", .preset = "mai2023", .settings = std::move(settings)};
    return fly(site, request, {.iterations = 40}).history.back().mean;
  };
  const auto as_default = best({});
  const std::vector<std::pair<std::string, std::string>> readings{{"trail_on", "nodes"},
                                                                  {"evaporation_scope", "global"},
                                                                  {"fitness_current", "each-ant"},
                                                                  {"heuristic", "goal-distance"},
                                                                  {"factor_unit", "cells"},
                                                                  {"window_side", "1"},
                                                                  {"window_height", "1"},
                                                                  {"join", "window"},
                                                                  {"q0_schedule", "constant"},
                                                                  {"height_above", "ground"},
                                                                  {"angle_unit", "deg"},
                                                                  {"safe_height_m", "500"},
                                                                  {"turn_max_deg", "100"},
                                                                  {"deposit", "ant-system"},
                                                                  {"constraints", "penalty"},
                                                                  {"main_direction", "y"},
                                                                  {"safety", "node"}};
  for (const auto& [name, value] : readings) EXPECT_NE(best({{name, value, "test"}}), as_default) << name;
}

TEST(TerrainAco, GoesThroughTheGapInTheWall) {
  const Plan plan = fly(test::ridge_site(), {.name = "terrain-aco"});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_TRUE(check(test::ridge_site(), plan.route).ok());
}

TEST(TerrainAco, SaysWhereAClosedWallEndsTheLattice) {
  const Plan plan = fly(test::ridge_site(false), {.name = "terrain-aco"});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_TRUE(plan.route.empty());
  EXPECT_NE(plan.why.find("at 3520 m along the straight line"), std::string::npos) << plan.why;
}

TEST(TerrainAco, OneStepIsEnoughForAShortWay) {
  const Plan plan = fly(test::flat_site(), {.name = "terrain-aco", .settings = {{"step_m", "1e6", "test"}}});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_EQ(plan.route.states.size(), 2U);
  EXPECT_NEAR(plan.cost, 10000, 1e-6);
}

TEST(TerrainAco, AtTheGoalThereIsNothingToFly) {
  Site site = test::flat_site();
  site.mission.goal = site.mission.start + Vec3(50, 0, 0);
  site.mission.tolerance_m = 60;
  const Plan plan = fly(site, {.name = "terrain-aco"});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_EQ(plan.route.states.size(), 1U);
}

TEST(TerrainAco, SaysThatNoPlaneLiesBetween) {
  Site site = test::flat_site();
  site.mission.goal = site.mission.start + Vec3(0, 0, 300);
  const Plan plan = fly(site, {.name = "terrain-aco"});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_NE(plan.why.find("same x and y"), std::string::npos) << plan.why;
}

TEST(TerrainAco, TellsDeadEndsAndTheLastChange) {
  const Plan plan = fly(test::simple_site(), {.name = "terrain-aco", .preset = "mai2023"}, {.iterations = 60});
  ASSERT_EQ(plan.history.size(), 60U);
  EXPECT_GT(plan.counters.at("dead_ends"), 0U);
  EXPECT_GT(plan.counters.at("barred_turn"), 0U);
  const std::uint64_t last = plan.counters.at("last_change");
  ASSERT_GE(last, 1U);
  EXPECT_EQ(plan.history[last - 1].best_so_far, plan.history.back().best_so_far);
}

std::string refusal(const Site& site) {
  const World world(site);
  return builtin_planners().find("terrain-aco")->refuses(Problem(world));
}

TEST(TerrainAco, RefusesWhatItCannotServe) {
  EXPECT_EQ(refusal(test::simple_site()), "");
  EXPECT_NE(refusal(test::open_air_site()).find("add terrain"), std::string::npos);
  EXPECT_NE(refusal(test::grid_site(test::drawn_grid(10, 1, 0))).find("grid-aco"), std::string::npos);
  Site nodes = test::simple_site();
  nodes.scenario.objective.model = CostModel::konatowski2019;
  EXPECT_NE(refusal(nodes).find("physical"), std::string::npos);
}

}  // namespace
}  // namespace alate
