// Navigation errors on a route of four corrections, each rule broken alone; the chance of success by brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "check/corrections.hpp"
#include "check/example.hpp"
#include "check/success_chance.hpp"

namespace alate::test {
namespace {

using Rules = std::set<std::string>;

/// Vertical, horizontal, vertical, horizontal, then the goal; legs of 10 km.
Site corrected_site() {
  Site site;
  site.mission = {.start = {0, 0, 0}, .goal = {50'000, 0, 0}};
  Navigation navigation{.drift_vertical = 0.001,
                        .drift_horizontal = 0.001,
                        .at_vertical = {.vertical = 25, .horizontal = 15},
                        .at_horizontal = {.vertical = 15, .horizontal = 25},
                        .theta = 35,
                        .residual = 5,
                        .start_id = 0,
                        .goal_id = 5};
  for (int i = 1; i <= 4; ++i) {
    navigation.points.push_back({.id = i,
                                 .position = Vec3(10'000.0 * i, 0, 0),
                                 .kind = i % 2 == 1 ? PointKind::vertical : PointKind::horizontal});
  }
  site.navigation = navigation;
  return site;
}

Route corrected_route() {
  Route route = make_route({{0, 0, 0}, {10'000, 0, 0}, {20'000, 0, 0}, {30'000, 0, 0}, {40'000, 0, 0}, {50'000, 0, 0}});
  for (int i = 0; i < 6; ++i) route.states[static_cast<std::size_t>(i)].point_id = i;
  return route;
}

TEST(Corrections, BaseRoutePassesWithItsWorstPlaces) {
  const Verdict verdict = check(corrected_site(), corrected_route());
  EXPECT_TRUE(verdict.ok());
  const Margin& vertical = *find_margin(verdict, "vertical_error");
  EXPECT_NEAR(vertical.margin, 5, 1e-9);  // 10 of 15 at point 2.
  EXPECT_EQ(vertical.leg, 2U);
  EXPECT_EQ(vertical.unit, "units");
  const Margin& horizontal = *find_margin(verdict, "horizontal_error");
  EXPECT_NEAR(horizontal.margin, 5, 1e-9);  // 10 of 15 at points 1 and 3.
  EXPECT_EQ(horizontal.leg, 1U);
  EXPECT_NEAR(find_margin(verdict, "final_error")->margin, 15, 1e-9);
  EXPECT_EQ(measure(corrected_site(), corrected_route()).corrections, 4U);
  EXPECT_EQ(measure(corrected_site(), corrected_route()).probability, 1.0);
}

TEST(Corrections, WithoutNavigationNothingIsChecked) {
  const Verdict verdict = check(example_site(), example_route());
  for (const char* rule : {"vertical_error", "horizontal_error", "final_error"})
    EXPECT_EQ(find_not_checked(verdict, rule)->why, "the scenario has no navigation");
  EXPECT_FALSE(measure(example_site(), example_route()).corrections);
  EXPECT_FALSE(measure(example_site(), example_route()).probability);
}

struct Mutation {
  std::string name;
  Rules rules;
  std::set<std::size_t> legs;
  std::function<void(Site&, Route&)> change;
};

void PrintTo(const Mutation& mutation, std::ostream* out) { *out << mutation.name; }

const std::vector<Mutation> kMutations{
    {"VerticalErrorAtAHorizontalPoint",
     {"vertical_error"},
     {2, 4},
     [](Site& site, Route&) { site.navigation->at_horizontal.vertical = 9.9; }},
    {"HorizontalErrorAtAVerticalPoint",
     {"horizontal_error"},
     {3},
     [](Site& site, Route& route) {
       site.navigation->at_vertical.horizontal = 10.5;
       site.navigation->points[1].position.y() = route.states[2].position.y() = 4000;
     }},
    {"ACorrectionIsLeftOut",
     {"horizontal_error"},
     {3, 4},
     [](Site&, Route& route) { route.states[2].point_id.reset(); }},
    {"FastDrift", {"vertical_error"}, {2, 3, 4}, [](Site& site, Route&) { site.navigation->drift_vertical = 0.00151; }},
    {"ErrorAtTheGoal", {"final_error"}, {5}, [](Site& site, Route&) { site.navigation->theta = 19.9; }},
    {"ThetaIsExcluded", {"final_error"}, {5}, [](Site& site, Route&) { site.navigation->theta = 20; }},
    {"NotAtItsPoint", {"arrival"}, {3}, [](Site& site, Route&) { site.navigation->points[2].position.x() += 0.5; }},
    {"UnknownPoint", {"arrival"}, {4}, [](Site&, Route& route) { route.states[4].point_id = 77; }},
};

class OneCorrection : public testing::TestWithParam<Mutation> {};

TEST_P(OneCorrection, BreaksItsRuleAndNoOther) {
  Site site = corrected_site();
  Route route = corrected_route();
  GetParam().change(site, route);
  const Verdict verdict = check(site, route);
  EXPECT_EQ(broken_rules(verdict), GetParam().rules);
  EXPECT_EQ(broken_legs(verdict), GetParam().legs);
}

INSTANTIATE_TEST_SUITE_P(Each, OneCorrection, testing::ValuesIn(kMutations),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(Corrections, LimitsThemselvesAreAllowed) {
  Site site = corrected_site();
  site.navigation->at_horizontal.vertical = site.navigation->at_vertical.horizontal = 10;
  EXPECT_TRUE(check(site, corrected_route()).ok());
}

TEST(Corrections, ErrorsGrowAlongArcs) {
  Site site = corrected_site();
  site.navigation->at_horizontal.vertical = 15;
  Route route = corrected_route();
  route.states[2].leg = LegKind::arc;
  route.states[2].arc = Arc{.center = {15'000, 0}, .radius_m = 5000, .angle_rad = kPi};
  const Rules expected{"vertical_error", "horizontal_error"};
  EXPECT_EQ(broken_rules(check(site, route)), expected);
  EXPECT_NEAR(find_margin(check(site, route), "vertical_error")->margin, 15 - 5 * kPi, 1e-6);
}

TEST(Corrections, RouteWithoutIdsIsCorrectedNowhere) {
  Route route = corrected_route();
  for (RouteState& state : route.states) state.point_id.reset();
  EXPECT_EQ(broken_rules(check(corrected_site(), route)), Rules{"final_error"});
  EXPECT_EQ(measure(corrected_site(), route).corrections, 0U);
  EXPECT_EQ(measure(corrected_site(), route).probability, 0.0);
}

/// The sum over all 2^k ways the corrections can go.
double by_enumeration(const Navigation& navigation, const std::vector<Visit>& visits) {
  double chance = 0;
  for (unsigned ways = 0; ways < (1U << (visits.size() - 1)); ++ways) {
    double weight = 1;
    double v = 0;
    double h = 0;
    bool alive = true;
    for (std::size_t i = 0; i < visits.size(); ++i) {
      v += navigation.drift_vertical * visits[i].length_m;
      h += navigation.drift_horizontal * visits[i].length_m;
      const CorrectionPoint* point = visits[i].point;
      if (point == nullptr) {
        alive = alive && v < navigation.theta && h < navigation.theta;
        continue;
      }
      const bool vertical = point->kind == PointKind::vertical;
      const Navigation::Limits& most = vertical ? navigation.at_vertical : navigation.at_horizontal;
      alive = alive && v <= most.vertical && h <= most.horizontal;
      const bool works = ((ways >> i) & 1U) != 0;
      weight *= works ? point->success : 1 - point->success;
      double& reset = vertical ? v : h;
      reset = works ? 0 : std::min(reset, navigation.residual);
    }
    if (alive) chance += weight;
  }
  return chance;
}

TEST(SuccessChance, EqualsTheSumOverAllWays) {
  std::mt19937 random(4);
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  int between = 0;
  for (int round = 0; round < 500; ++round) {
    Site site = corrected_site();
    Navigation& navigation = *site.navigation;
    navigation.residual = number(0, 12);
    navigation.points.clear();
    std::vector<Visit> visits;
    for (int i = 0; i < 9; ++i) {
      navigation.points.push_back({.id = i + 1,
                                   .kind = random() % 2 == 0 ? PointKind::vertical : PointKind::horizontal,
                                   .success = random() % 2 == 0 ? 1 : number(0, 1)});
    }
    for (const CorrectionPoint& point : navigation.points)
      visits.push_back({.point = &point, .length_m = number(0, 9e3)});
    visits.push_back({.length_m = 5000});
    const double expected = by_enumeration(navigation, visits);
    EXPECT_NEAR(*success_chance(navigation, visits), expected, 1e-12);
    between += expected > 0.01 && expected < 0.99 ? 1 : 0;
  }
  EXPECT_GT(between, 50);
}

TEST(SuccessChance, EndsWithoutAnAnswerWhereItWouldTakeForever) {
  Navigation navigation{.drift_vertical = 1e-9,
                        .drift_horizontal = 1e-9,
                        .at_vertical = {.vertical = 25, .horizontal = 15},
                        .at_horizontal = {.vertical = 15, .horizontal = 25},
                        .theta = 30,
                        .residual = 5};
  const CorrectionPoint vertical{.kind = PointKind::vertical, .success = 0.001};
  const CorrectionPoint horizontal{.kind = PointKind::horizontal, .success = 0.001};
  std::vector<Visit> visits;
  for (int i = 0; i < 50'000; ++i) visits.push_back({.point = i % 2 == 0 ? &vertical : &horizontal, .length_m = 1});
  EXPECT_FALSE(success_chance(navigation, visits));
}

}  // namespace
}  // namespace alate::test
