// label-setting where legs turn: problem 2 of Zhou et al. 2020.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "space/correction_route.hpp"
#include "support/correction_sites.hpp"
#include "support/fly.hpp"

namespace alate::test {
namespace {

Site turning(Site site, TurnModel model, double radius_m = 200) {
  site.navigation->turn_model = model;
  site.navigation->turn_radius_m = radius_m;
  return site;
}

Plan fly_turning(const Site& site, bool front = false, RunOptions options = {}) {
  const World world(site);
  Problem problem(world);
  problem.front = front;
  const ChosenPlanner chosen = choose_planner(builtin_planners(), problem, {.name = "label-setting"});
  Executor executor(1);
  RunContext run(executor, std::move(options));
  return chosen.planner.plan(problem, run);
}

std::string refusal(const Site& site) {
  const World world(site);
  return builtin_planners().find("label-setting")->refuses(Problem(world));
}

TEST(TurningPlan, PassesTheCheckInEitherModel) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Site straight = drawn_site(CorrectionLaw::set1, 300, seed);
    const Plan shortest = fly_turning(straight);
    for (const TurnModel model : {TurnModel::arc_tangent, TurnModel::free_heading}) {
      const Site site = turning(straight, model);
      const Plan plan = fly_turning(site);
      if (plan.route.empty()) continue;
      ++found;
      const Verdict verdict = check(site, plan.route);
      EXPECT_TRUE(verdict.ok()) << verdict.violations.front().rule << " on leg " << verdict.violations.front().leg;
      EXPECT_NEAR(measure(site, plan.route).cost, plan.cost, 1e-6);
      EXPECT_GT(plan.cost, shortest.cost);
      EXPECT_EQ(plan.outcome, model == TurnModel::arc_tangent ? Outcome::optimal : Outcome::feasible);
      if (model == TurnModel::arc_tangent) {
        EXPECT_EQ(plan.lower_bound, plan.cost);
      } else {
        EXPECT_NEAR(plan.lower_bound, shortest.cost, 1e-3);
      }
    }
  }
  EXPECT_GT(found, 5);
}

TEST(TurningPlan, BeginsWithTheStartsHeading) {
  Site site = turning(drawn_site(CorrectionLaw::set1, 300, 1), TurnModel::arc_tangent);
  const Plan free = fly_turning(site);
  site.mission.heading_given = true;
  site.mission.heading_rad = kPi;
  const Plan plan = fly_turning(site);
  ASSERT_FALSE(plan.route.empty());
  EXPECT_EQ(plan.route.states[1].leg, LegKind::arc);
  EXPECT_TRUE(check(site, plan.route).ok());
  EXPECT_GT(plan.cost, free.cost);
}

TEST(TurningPlan, SaysThatOnlyTheTurnsForbidIt) {
  Site site;
  site.scenario.objective.climb = 0;
  site.mission.start = Vec3::Zero();
  site.mission.goal = {10000, 300, 0};
  site.navigation = Navigation{.points = {{.id = 4, .position = {10000, 0, 0}, .kind = PointKind::vertical}},
                               .drift_vertical = 0.00119,
                               .drift_horizontal = 0.001,
                               .at_vertical = {12, 11},
                               .at_horizontal = {11, 12},
                               .theta = 11.5};
  EXPECT_EQ(fly_turning(site).outcome, Outcome::optimal);
  const Plan plan = fly_turning(turning(site, TurnModel::arc_tangent));
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_EQ(plan.why, "straight legs lead to the goal within the error limits, but none that turn on 200 m");
}

TEST(TurningPlan, RefusesWhatItCannotTurnRound) {
  Site site = turning(drawn_site(CorrectionLaw::set1, 30, 1), TurnModel::arc_tangent);
  EXPECT_EQ(refusal(site), "");
  site.vehicle.turn_radius_m = 200;
  EXPECT_EQ(refusal(site), "");
  site.vehicle.turn_radius_m = 201;
  EXPECT_NE(refusal(site).find("vehicle.turn_radius_m"), std::string::npos);
  site.vehicle.turn_radius_m.reset();
  site.vehicle.climb_rad = 0.1;
  EXPECT_NE(refusal(site).find("open air"), std::string::npos);
}

struct Contest {
  const char* name;
  CorrectionLaw law;
  double arc_tangent_m;
  double free_heading_m;
  std::vector<int> corrections;  ///< Along the front.
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const Contest& contest, std::ostream* out) { *out << contest.name; }

class ContestTurns : public testing::TestWithParam<Contest> {};

TEST_P(ContestTurns, AreSolvedExactly) {
  ALATE_NEEDS_CONTEST_POINTS;
  const Contest& contest = GetParam();
  const Site straight = correction_site(contest_field(contest.law));
  const Site site = turning(straight, TurnModel::arc_tangent);
  const Plan plan = fly_turning(site, true);
  EXPECT_EQ(plan.outcome, Outcome::optimal);
  EXPECT_NEAR(plan.cost, contest.arc_tangent_m, 1e-5);
  EXPECT_TRUE(check(site, plan.route).ok());
  std::vector<int> corrections;
  for (const FrontPoint& point : plan.front) {
    corrections.push_back(point.corrections);
    const Route route = route_through(site, point.points).route;
    EXPECT_TRUE(check(site, route).ok());
    EXPECT_NEAR(measure(site, route).length_m, point.length_m, 1e-6);
  }
  EXPECT_EQ(corrections, contest.corrections);
  const Site free = turning(straight, TurnModel::free_heading);
  const Plan freed = fly_turning(free);
  EXPECT_NEAR(freed.cost, contest.free_heading_m, 1e-4);
  EXPECT_TRUE(check(free, freed.route).ok());
}

const std::vector<Contest> kContests{
    {"Set1", CorrectionLaw::set1, 103563.189161, 103527.227600, {8, 9}},
    {"Set2", CorrectionLaw::set2, 109467.713322, 109374.171997, {12}},
};

INSTANTIATE_TEST_SUITE_P(Each, ContestTurns, testing::ValuesIn(kContests),
                         [](const auto& param_info) { return param_info.param.name; });

struct Published {
  std::vector<int> ids;
  double claimed_m;
  double straight_m;  ///< Ours, over the same points.
  double turning_m;
  bool passes;
};

/// Claims for problem 2 on set 1, both below the straight lines between their points.
TEST(PublishedTurns, AreShorterThanStraightLegsAllow) {
  ALATE_NEEDS_CONTEST_POINTS;
  const Site straight = correction_site(contest_field(CorrectionLaw::set1));
  const Site site = turning(straight, TurnModel::arc_tangent);
  const Published planner{.ids = {503, 200, 136, 80, 237, 278, 375, 172, 340, 277},  // github: QPromise/Route-Planning
                          .claimed_m = 109030.78,
                          .straight_m = 110055.783008,
                          .turning_m = 110258.641740,
                          .passes = true};
  const Published paper{.ids = {346, 200, 294, 136, 108, 74, 462, 543, 369, 457, 388, 436},  // the paper's table 3
                        .claimed_m = 14957.842315,
                        .straight_m = 118509.412328,
                        .turning_m = 118756.509672,
                        .passes = false};
  for (const Published& published : {planner, paper}) {
    const Route route = route_through(site, published.ids).route;
    EXPECT_NEAR(measure(site, route).length_m, published.turning_m, 1e-5);
    EXPECT_NEAR(measure(straight, route_through(straight, published.ids).route).length_m, published.straight_m, 1e-5);
    EXPECT_EQ(check(site, route).ok(), published.passes);
    EXPECT_LT(published.claimed_m, published.straight_m);
  }
}

}  // namespace
}  // namespace alate::test
