#include <gtest/gtest.h>

#include <algorithm>

#include "alate/check/check.hpp"
#include "alate/plan/registry.hpp"
#include "space/error_cases.hpp"
#include "support/correction_sites.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

Plan plan_with(const Site& site, Preference prefer, bool front, RunOptions options = {}) {
  const World world(site);
  Problem problem(world);
  problem.prefer = prefer;
  problem.front = front;
  Executor executor(1);
  RunContext run(executor, std::move(options));
  const ChosenPlanner chosen = choose_planner(builtin_planners(), problem, {.name = "label-setting"});
  return chosen.planner.plan(problem, run);
}

std::string refusal(const Site& site, const std::string& planner = "label-setting") {
  const World world(site);
  return builtin_planners().find(planner)->refuses(Problem(world));
}

TEST(LabelSettingPlanner, IsChosenWhereThereAreCorrectionPoints) {
  const World world(test::drawn_site(CorrectionLaw::set1, 100, 1));
  EXPECT_EQ(choose_planner(builtin_planners(), Problem(world), {}).name, "label-setting");
}

TEST(LabelSettingPlanner, RefusesWhatItCannotHonour) {
  const Site site = test::drawn_site(CorrectionLaw::set1, 50, 1);
  EXPECT_EQ(refusal(site), "");
  const auto with = [&](const auto& change) {
    Site other = site;
    change(other);
    return refusal(other);
  };
  const auto contains = [](const std::string& text, const char* word) { return text.find(word) != std::string::npos; };
  EXPECT_TRUE(contains(with([](Site& s) { s.navigation.reset(); }), "navigation"));
  const auto turning = [](Site& s) {
    s.navigation->turn_model = TurnModel::arc_tangent;
    s.navigation->turn_radius_m = 50;
    s.vehicle.turn_radius_m = 100;
  };
  EXPECT_TRUE(contains(with(turning), "turn_radius_m"));
  EXPECT_TRUE(contains(with([](Site& s) { s.vehicle.turn_radius_m = 100; }), "turn_radius_m"));
  EXPECT_TRUE(contains(with([](Site& s) { s.scenario.objective.climb = 2; }), "climb"));
  EXPECT_TRUE(
      contains(with([](Site& s) { s.scenario.objective.model = CostModel::konatowski2019; }), "objective.model"));
  const auto threat = [](Site& s) { s.threats.push_back({.name = "radar", .radius_m = 10}); };
  EXPECT_TRUE(contains(with(threat), "threat"));
  EXPECT_EQ(with([&](Site& s) {
              threat(s);
              s.scenario.objective.threat = 0;
            }),
            "");
}

TEST(LabelSettingPlanner, AttitudePlannersKnowNothingOfDrift) {
  Site site = test::open_air_site();
  ASSERT_EQ(refusal(site, "beam"), "");
  site.navigation = draw_corrections(CorrectionLaw::set1, 10, 1).navigation;
  for (const char* planner : {"beam", "greedy", "attitude-aco"})
    EXPECT_NE(refusal(site, planner).find("navigation errors"), std::string::npos);
}

TEST(LabelSettingPlanner, TakesThePreferredRouteOfTheFront) {
  const Site site = test::drawn_site(CorrectionLaw::set2, 325, 1);
  const Plan shortest = plan_with(site, Preference::length, false);
  const Plan all = plan_with(site, Preference::length, true);
  ASSERT_EQ(shortest.outcome, Outcome::optimal);
  EXPECT_TRUE(shortest.front.empty());
  ASSERT_GE(all.front.size(), 3U);
  EXPECT_NEAR(all.cost, shortest.cost, 1e-6);
  EXPECT_NEAR(all.lower_bound, all.cost, 1e-6);
  const auto by_order = [](const FrontPoint& a, const FrontPoint& b) {
    return std::pair(a.corrections, a.length_m) < std::pair(b.corrections, b.length_m);
  };
  EXPECT_TRUE(std::ranges::is_sorted(all.front, by_order));

  const Plan few = plan_with(site, Preference::corrections, false);
  EXPECT_EQ(static_cast<int>(few.route.states.size()) - 2, all.front.front().corrections);
  EXPECT_NEAR(few.cost, all.front.front().length_m, 1e-6);
  EXPECT_LE(few.lower_bound, shortest.cost);

  const Plan sure = plan_with(site, Preference::probability, false);
  const double best = std::ranges::max_element(all.front, {}, &FrontPoint::probability)->probability;
  std::vector<CorrectionPoint> points;
  for (const RouteState& state : sure.route.states)
    if (state.point_id)
      points.push_back(*std::ranges::find(site.navigation->points, *state.point_id, &CorrectionPoint::id));
  EXPECT_NEAR(success_probability(*site.navigation, site.mission.start, site.mission.goal, points), best, 1e-12);
  EXPECT_GT(best, all.front.front().probability);
}

TEST(LabelSettingPlanner, KeepsOutOfCoresAndUnderClimbLimits) {
  const Site cored = test::cored_site();
  Site open = cored;
  open.threats.clear();
  Site level = open;
  level.vehicle.climb_rad = level.vehicle.descent_rad = radians(5);
  const double free_cost = plan_with(open, Preference::length, false).cost;
  for (const Site& site : {cored, level}) {
    const Plan plan = plan_with(site, Preference::length, false);
    ASSERT_EQ(plan.outcome, Outcome::optimal) << plan.why;
    EXPECT_TRUE(check(site, plan.route).ok());
    EXPECT_GT(plan.cost, free_cost);
    EXPECT_FALSE(check(site, plan_with(open, Preference::length, false).route).ok());
    EXPECT_NEAR(plan_with(site, Preference::length, true).cost, plan.cost, 1e-6);
  }
}

TEST(LabelSettingPlanner, SaysWhyThereIsNoRoute) {
  Site site = test::drawn_site(CorrectionLaw::set1, 611, 1);
  const double shortest = plan_with(site, Preference::length, false).cost;
  site.vehicle.range_m = shortest - 1;
  for (const bool front : {false, true}) {
    const Plan plan = plan_with(site, Preference::length, front);
    EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
    EXPECT_NE(plan.why.find("beyond the range"), std::string::npos) << plan.why;
  }
  site.vehicle.range_m.reset();
  std::erase_if(site.navigation->points,
                [](const CorrectionPoint& p) { return p.position.x() > 30'000 && p.position.x() < 62'000; });
  const Plan plan = plan_with(site, Preference::length, false);
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_TRUE(plan.route.empty());
  EXPECT_NE(plan.why.find("the errors allow"), std::string::npos) << plan.why;
}

TEST(LabelSettingPlanner, ADeadlineLeavesAFeasibleRouteAndAValidBound) {
  const Site site = test::drawn_site(CorrectionLaw::set1, 5000, 3);
  const double shortest = plan_with(site, Preference::length, false).cost;
  int feasible = 0;
  for (const double limit_s : {0.0005, 0.001, 0.002, 0.003, 0.005, 0.01}) {
    const Plan plan = plan_with(site, Preference::length, true, {.time_limit_s = limit_s});
    EXPECT_LE(plan.lower_bound, shortest + 1e-6);
    if (plan.outcome != Outcome::feasible) continue;
    ++feasible;
    EXPECT_GE(plan.cost, shortest - 1e-6);
    EXPECT_TRUE(check(site, plan.route).ok());
    EXPECT_TRUE(plan.front.empty());
    EXPECT_FALSE(plan.reproducible);
  }
  EXPECT_GT(feasible, 0);
}

}  // namespace
}  // namespace alate
