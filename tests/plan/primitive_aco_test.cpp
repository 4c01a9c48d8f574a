// Ants over real ground, on sites where the answer is known.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "support/fly.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

const World& ridge() {
  static const World kWorld(test::ridge_site());
  return kWorld;
}

TEST(PrimitiveAco, RoundsAWallThroughItsGapFromNothing) {
  for (const char* preset : {"guided", "mmas"}) {
    const Plan plan =
        test::fly(ridge(), {"primitive-aco", preset, {{"first_route", "none", "test"}}}, {.iterations = 15});
    ASSERT_EQ(plan.outcome, Outcome::feasible) << preset << ": " << plan.why;
    EXPECT_TRUE(check(ridge().site(), plan.route).ok()) << preset;
    // Over the gap's middle at the least: 4 km east and 4 km north, twice.
    EXPECT_GT(plan.cost, 2 * std::hypot(3900, 3900)) << preset;
    EXPECT_LT(plan.cost, 2 * std::hypot(4000, 4000) * 1.1) << preset;
    EXPECT_GT(plan.history.back().arrived, 0.3) << preset;
  }
}

TEST(PrimitiveAco, FindsNoWayThroughAWallWithoutAGap) {
  const World world(test::ridge_site(false));
  for (const char* preset : {"guided", "mmas"}) {
    const Plan plan = test::fly(world, {"primitive-aco", preset, {}}, {.iterations = 4});
    EXPECT_EQ(plan.outcome, Outcome::infeasible_proven) << preset;
    EXPECT_FALSE(plan.why.empty()) << preset;
  }
}

/// From the search's answer on, ants and changes only better it; and ants walk where it has laid trails.
TEST(PrimitiveAco, BettersTheAnswerOfTheSearch) {
  const Plan search = test::fly(ridge(), {"primitive-aco", "guided", {}}, {.iterations = 2});
  const Plan plan = test::fly(ridge(), {"primitive-aco", "guided", {}}, {.iterations = 20});
  EXPECT_TRUE(search.history.empty());
  ASSERT_EQ(plan.history.size(), 18U);
  EXPECT_LT(plan.cost, search.cost);
  EXPECT_GT(plan.history.front().known, 0.05);
}

/// With alpha = 0 trails count for nothing, and other ways are walked.
TEST(PrimitiveAco, AntsMindTheTrail) {
  const auto mean_of_last = [](const char* alpha) {
    const Plan plan =
        test::fly(ridge(), {"primitive-aco", "mmas", {{"alpha", alpha, "test"}, {"temperature", "1", "test"}}},
                  {.iterations = 20});
    return plan.history.back().mean.value_or(1e9);
  };
  EXPECT_LT(mean_of_last("2"), mean_of_last("0"));
}

TEST(PrimitiveAco, ChoosesAHeadingWhereNoneIsGiven) {
  Site site = test::open_air_site();
  site.threats.clear();
  site.mission.heading_given = false;
  site.mission.tolerance_m = 1;
  const World world(site);
  const Plan plan = test::fly(world, {"primitive-aco", "guided", {{"first_route", "none", "test"}}}, {.iterations = 5});
  ASSERT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_LT(plan.cost, 1.001 * plan.lower_bound);
}

TEST(PrimitiveAco, IsDoneWhereItBegins) {
  Site site = test::open_air_site();
  site.mission.goal = site.mission.start;
  const Plan plan = test::fly(site, {"primitive-aco", "", {}});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_EQ(plan.route.states.size(), 1U);
}

}  // namespace
}  // namespace alate
