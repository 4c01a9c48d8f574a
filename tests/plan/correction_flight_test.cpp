// Flights over correction points and real ground.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "plan/flight/correction_legs.hpp"
#include "support/drifting_sites.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

std::vector<int> points_of(const Route& route) {
  std::vector<int> ids;
  for (const RouteState& state : route.states)
    if (state.point_id) ids.push_back(*state.point_id);
  return ids;
}

TEST(CorrectionFlight, LeadsOverPointsRoundTheWall) {
  const World world(test::drifting_site(true));
  const Plan plan = test::fly(world, {.name = "interval-astar"}, {.iterations = 60});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_EQ(plan.stop, Stop::finished);  // sequence and lengths agree
  const Verdict verdict = check(world.site(), plan.route);
  for (const Violation& broken : verdict.violations)
    ADD_FAILURE() << broken.rule << " on leg " << broken.leg << ": " << broken.value << ", allowed " << broken.limit;
  EXPECT_EQ(verdict.status, Status::pass);
  const std::vector<int> points = points_of(plan.route);
  EXPECT_EQ(points, (std::vector<int>{1, 2, 3}));
  EXPECT_NEAR(plan.cost, measure(world.site(), plan.route).cost, 1e-9 * plan.cost);
  EXPECT_GT(plan.cost, plan.lower_bound);
  EXPECT_GT(plan.counters.at("legs"), points.size());
}

/// Errors grow with what is flown: straight legs would keep limits that turns and detours break.
TEST(CorrectionFlight, MindsThatTurnsMakeLegsLonger) {
  Site site = test::open_air_site();
  site.threats.clear();
  site.mission.tolerance_m = 0;
  site.scenario.objective = {.model = CostModel::physical, .length = 1, .threat = 0, .climb = 0};
  const auto with_limit = [&](double theta) {
    Navigation navigation{.drift_vertical = 0.001,
                          .drift_horizontal = 0.001,
                          .at_vertical = {5, 5},
                          .at_horizontal = {5, 5},
                          .theta = theta};
    navigation.points.push_back({.id = 1, .position = {1000, 400, 320}, .kind = PointKind::vertical});
    site.navigation = navigation;
    return test::fly(site, {.name = "interval-astar"}, {.iterations = 20});
  };
  const double straight = (site.mission.goal - site.mission.start).norm();
  EXPECT_EQ(with_limit(1.05e-3 * straight).outcome, Outcome::feasible);
  EXPECT_EQ(with_limit(1.00001e-3 * straight).outcome, Outcome::none_found);  // it begins 30 degrees off
  EXPECT_EQ(with_limit(0.9e-3 * straight).outcome, Outcome::infeasible_proven);
}

TEST(CorrectionFlight, StopsWhenToldWithWhatItHas) {
  const World world(test::drifting_site(true));
  const Plan cut = test::fly(world, {.name = "interval-astar"}, {.iterations = 1});
  const Plan whole = test::fly(world, {.name = "interval-astar"}, {.iterations = 60});
  EXPECT_TRUE(cut.route.empty() || cut.cost >= whole.cost);
  std::stop_source source;
  source.request_stop();
  const Plan none = test::fly(world, {.name = "interval-astar"}, {.stop = source.get_token()});
  EXPECT_EQ(none.outcome, Outcome::none_found);
  EXPECT_FALSE(none.reproducible);
}

TEST(CorrectionFlight, SaysWhatItNeeds) {
  Site site = test::drifting_site(true);
  site.navigation->turn_model = TurnModel::arc_tangent;
  site.navigation->turn_radius_m = 100;
  const World turning(site);
  const PlannerEntry& entry = *builtin_planners().find("interval-astar");
  EXPECT_NE(entry.refuses(Problem(turning)).find("turn_model"), std::string::npos);
  site.navigation->turn_model = TurnModel::none;
  site.vehicle.turn_radius_m.reset();
  const World cornered(site);
  EXPECT_NE(entry.refuses(Problem(cornered)).find("turn_radius_m"), std::string::npos);
}

TEST(CorrectionFlight, FliesTheExample) {
  const World world(load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro-corrections/scenario.yaml")));
  const Plan plan = test::fly(world, {.name = "interval-astar"}, {.iterations = 200});
  ASSERT_EQ(plan.outcome, Outcome::feasible) << plan.why;
  EXPECT_EQ(plan.stop, Stop::finished);
  EXPECT_TRUE(check(world.site(), plan.route).ok());
  EXPECT_GT(points_of(plan.route).size(), 3U);
}

}  // namespace
}  // namespace alate
