#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

using test::fly;

class Terrain : public testing::TestWithParam<const char*> {};

TEST_P(Terrain, GoesThroughTheGapInTheWall) {
  const Plan plan = fly(test::ridge_site(), {.name = GetParam()});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  bool crossed = false;
  for (std::size_t i = 1; i < plan.route.states.size(); ++i) {
    const Segment leg = plan.route.segment(i);
    if ((leg.a.x() < 5000) == (leg.b.x() < 5000)) continue;
    crossed = true;
    EXPECT_GT(leg.a.y(), 5950);
    EXPECT_LT(leg.a.y(), 7050);
  }
  EXPECT_TRUE(crossed);
}

TEST_P(Terrain, SaysWhereAClosedWallEndsTheWay) {
  const Plan plan = fly(test::ridge_site(false), {.name = GetParam()});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_TRUE(plan.route.empty());
  EXPECT_NE(plan.why.find("no way"), std::string::npos) << plan.why;
  EXPECT_NE(plan.why.find("it ends at x 5"), std::string::npos) << plan.why;
}

TEST_P(Terrain, SaysThatNothingLeavesTheStart) {
  Site site = test::ridge_site();
  site.mission.start = {4550, 2000, 150};  // 100 m before the wall, too near to turn away
  const Plan plan = fly(site, {.name = GetParam()});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_NE(plan.why.find("no move from the start"), std::string::npos) << plan.why;
}

TEST_P(Terrain, RoundsAThreatInOpenAir) {
  const Site site = test::open_air_site();
  const Plan plan = fly(site, {.name = GetParam()});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_LT(plan.cost, 1.15 * plan.lower_bound);
}

TEST_P(Terrain, AtTheGoalThereIsNothingToFly) {
  Site site = test::ridge_site();
  site.mission.start = site.mission.goal + Vec3(50, 0, 0);
  const Plan plan = fly(site, {.name = GetParam()});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_EQ(plan.route.states.size(), 1U);
  EXPECT_EQ(plan.cost, 0);
  EXPECT_EQ(plan.lower_bound, 0);
}

INSTANTIATE_TEST_SUITE_P(Planners, Terrain, testing::Values("greedy", "beam"));

constexpr const char* kJacksboro = ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml";

/// The first pass takes some 10 ms after 40 ms of guidance; the limit leaves room for instrumented builds.
TEST(Jacksboro, ATimeLimitGivesTheBestSoFar) {
  const World world(load_site(load_scenario(kJacksboro)));
  const Plan plan = fly(world, {.name = "beam"}, {.iterations = 1000000000, .time_limit_s = 1.5});
  EXPECT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_EQ(plan.stop, Stop::deadline);
  EXPECT_FALSE(plan.reproducible);
}

TEST(Jacksboro, BeamBeatsGreedyAndBothAreNearTheBound) {
  const World world(load_site(load_scenario(kJacksboro)));
  const Plan greedy = fly(world, {.name = "greedy"});
  const Plan beam = fly(world, {.name = "beam"});
  ASSERT_EQ(greedy.outcome, Outcome::feasible) << greedy.why;
  ASSERT_EQ(beam.outcome, Outcome::feasible) << beam.why;
  EXPECT_LT(beam.cost, greedy.cost);
  EXPECT_LT(beam.cost, 1.12 * beam.lower_bound);
  EXPECT_TRUE(beam.reproducible);
}

}  // namespace
}  // namespace alate
