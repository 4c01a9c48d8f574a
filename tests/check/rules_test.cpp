// Corner cases of single rules, and routes that make no sense.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check/example.hpp"

namespace alate::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A level quarter turn to the right, from north to east, between two straight legs.
Route quarter_turn(double radius) {
  Route route = make_route({{1000, 1000, 300}, {1000, 2000, 300}, {1000 + radius, 2000 + radius, 300}, {2500, 0, 300}});
  route.states[2].leg = LegKind::arc;
  route.states[2].arc = Arc{.center = {1000 + radius, 2000}, .radius_m = radius, .angle_rad = kPi / 2};
  route.states[3].position = {2500, 2000 + radius, 300};
  return route;
}

Site turning_site() {
  Site site;
  site.mission = {.start = {1000, 1000, 300}, .goal = {2500, 2200, 300}, .tolerance_m = 1000};
  site.vehicle.turn_radius_m = 150;
  return site;
}

TEST(Turn, SmoothArcPassesWithItsOwnRadius) {
  const Verdict verdict = check(turning_site(), quarter_turn(200));
  EXPECT_TRUE(verdict.ok());
  EXPECT_NEAR(find_margin(verdict, "turn")->margin, 50, 1e-9);
}

TEST(Turn, ArcTighterThanAllowedFails) {
  EXPECT_EQ(broken_legs(check(turning_site(), quarter_turn(100))), std::set<std::size_t>{2});
}

TEST(Turn, KinkAtAnArcFails) {
  Route route = quarter_turn(200);
  route.states[3].position.y() += 1;
  EXPECT_EQ(broken_legs(check(turning_site(), route)), std::set<std::size_t>{3});
}

TEST(Turn, ArcThatMissesItsEndFails) {
  Route route = quarter_turn(200);
  route.states[2].arc->angle_rad = kPi / 2 - 0.01;
  EXPECT_TRUE(broken_legs(check(turning_site(), route)).contains(2));
}

TEST(Turn, ACornerMayUseAllOfALegThatNoOtherNeeds) {
  Site site = turning_site();
  site.mission.start = {0, 0, 0};
  EXPECT_NEAR(find_margin(check(site, make_route({{0, 0, 0}, {0, 400, 0}, {1000, 400, 0}})), "turn")->margin, 250,
              1e-9);
}

TEST(Turn, TwoCornersShareTheLegBetweenThem) {
  Site site = turning_site();
  site.mission.start = {0, 0, 0};
  const Route square = make_route({{0, -2000, 0}, {0, 0, 0}, {600, 0, 0}, {600, -2000, 0}});
  EXPECT_NEAR(find_margin(check(site, square), "turn")->margin, 600 / (2 * std::tan(kPi / 4)) - 150, 1e-9);
  const Route hook = make_route({{0, -2000, 0}, {0, 0, 0}, {600, 0, 0}, {2600, 2000, 0}});
  const double room = 600 / (std::tan(kPi / 4) + std::tan(kPi / 8));
  EXPECT_NEAR(find_margin(check(site, hook), "turn")->margin, room - 150, 1e-9);
}

TEST(Turn, ReversalHasNoRadius) {
  const Verdict verdict = check(turning_site(), make_route({{1000, 1000, 300}, {1000, 3000, 300}, {1000, 1500, 300}}));
  ASSERT_TRUE(broken_rules(verdict).contains("turn"));
  EXPECT_NEAR(find_margin(verdict, "turn")->margin, -150, 1e-6);
}

TEST(Turn, CannotHideBehindARepeatedPoint) {
  const Verdict verdict = check(
      turning_site(),
      make_route({{1000, 1000, 300}, {1000, 1100, 300}, {1000, 1100, 300}, {1000, 1100, 310}, {1200, 1100, 310}}));
  EXPECT_EQ(broken_legs(verdict), (std::set<std::size_t>{4}));
}

TEST(Turn, StraightRouteHasAFiniteMargin) {
  const Verdict verdict = check(turning_site(), make_route({{1000, 1000, 300}, {2500, 2200, 300}}));
  EXPECT_TRUE(verdict.ok());
  EXPECT_TRUE(std::isfinite(find_margin(verdict, "turn")->margin));
}

TEST(ThreatCore, CylinderCountsBetweenFloorAndTopOnly) {
  Site site;
  site.mission = {.start = {0, 0, 500}, .goal = {1000, 0, 500}, .tolerance_m = 1};
  site.threats = {{.name = "mast",
                   .shape = Threat::Shape::cylinder,
                   .center = {500, 0, 0},
                   .radius_m = 300,
                   .core_m = 100,
                   .floor_m = 0,
                   .top_m = 490}};
  const Route route = make_route({{0, 0, 500}, {1000, 0, 500}});
  EXPECT_TRUE(check(site, route).ok());
  EXPECT_NEAR(find_margin(check(site, route), "threat_core")->margin, 10, 1e-9);
  site.threats[0].top_m = 510;
  const Verdict inside = check(site, route);
  EXPECT_EQ(broken_rules(inside), std::set<std::string>{"threat_core"});
  EXPECT_NEAR(inside.violations.front().value, 0, 1e-9);
}

TEST(ThreatCore, DivingLegIsJudgedOnlyInsideTheBand) {
  Site site;
  site.mission = {.start = {0, 0, 1000}, .goal = {1000, 0, 0}, .tolerance_m = 1};
  site.threats = {{.name = "mast", .shape = Threat::Shape::cylinder, .center = {500, 0, 0}, .radius_m = 300}};
  site.threats[0].core_m = 100;
  site.threats[0].top_m = 300;
  const Verdict verdict = check(site, make_route({{0, 0, 1000}, {1000, 0, 0}}));
  EXPECT_TRUE(verdict.ok());
  EXPECT_NEAR(find_margin(verdict, "threat_core")->margin, 100, 1e-9);
}

TEST(Unknown, VoidUnderALegMakesTheVerdictUnknown) {
  Site site = example_site();
  auto& raster = std::get<HeightRaster>(site.ground);
  const int post = (raster.rows - 2) * raster.columns + 12;
  raster.posts[static_cast<std::size_t>(post)] = std::numeric_limits<float>::quiet_NaN();
  const Verdict verdict = check(site, example_route());
  EXPECT_EQ(verdict.status, Status::unknown);
  ASSERT_NE(find_not_checked(verdict, "terrain_clearance"), nullptr);
  EXPECT_TRUE(find_not_checked(verdict, "terrain_clearance")->unknown);
  EXPECT_NE(find_not_checked(verdict, "terrain_clearance")->why.find("leg 2"), std::string::npos);
  EXPECT_FALSE(measure(site, example_route()).min_clearance_m);
  site.vehicle.range_m = 1;
  EXPECT_EQ(check(site, example_route()).status, Status::fail);
}

TEST(NotChecked, BareScenarioJudgesArrivalAlone) {
  Site site;
  site.mission = {.start = {0, 0, 0}, .goal = {100, 0, 0}, .tolerance_m = 1};
  const Verdict verdict = check(site, make_route({{0, 0, 0}, {100, 0, 0}}));
  EXPECT_EQ(verdict.status, Status::pass);
  ASSERT_EQ(verdict.margins.size(), 1U);
  EXPECT_EQ(verdict.margins.front().rule, "arrival");
  EXPECT_EQ(verdict.not_checked.size(), 12U);
  for (const NotChecked& entry : verdict.not_checked) EXPECT_FALSE(entry.why.empty() || entry.unknown);
}

TEST(Nonsense, EmptyRouteBreaksArrival) {
  const Verdict verdict = check(example_site(), Route{});
  EXPECT_EQ(broken_rules(verdict), std::set<std::string>{"arrival"});
  EXPECT_EQ(measure(example_site(), Route{}).cost, 0);
}

TEST(Nonsense, SingleStateIsJudgedWhereItStands) {
  EXPECT_EQ(broken_rules(check(example_site(), make_route({{500, 150, 300}}))), std::set<std::string>{"arrival"});
  EXPECT_EQ(broken_rules(check(example_site(), make_route({{500, 150, 20}}))),
            (std::set<std::string>{"arrival", "terrain_clearance"}));
}

TEST(Nonsense, PositionsThatAreNoNumbersBreakBoundsWithFiniteValues) {
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e300}) {
    for (std::size_t i = 0; i < example_route().states.size(); ++i) {
      Route route = example_route();
      route.states[i].position.z() = bad;
      const Verdict verdict = check(example_site(), route);
      ASSERT_EQ(verdict.violations.size(), 1U);
      EXPECT_EQ(verdict.violations.front().rule, "bounds");
      EXPECT_EQ(verdict.violations.front().leg, i);
      EXPECT_TRUE(std::isfinite(verdict.violations.front().value));
      EXPECT_TRUE(verdict.violations.front().where.allFinite());
      EXPECT_TRUE(std::isfinite(measure(example_site(), route).cost));
    }
  }
}

TEST(Nonsense, AbsurdArcsBreakBounds) {
  for (const Arc& arc : {Arc{{0, 0}, kNaN, 1}, Arc{{kNaN, 0}, 1, 1}, Arc{{0, 0}, -1, 1}, Arc{{0, 0}, 0, 1},
                         Arc{{0, 0}, 1, kInfinity}, Arc{{0, 0}, 1e12, 1}}) {
    Route route = example_route();
    route.states[2].arc = arc;
    EXPECT_EQ(broken_rules(check(example_site(), route)), std::set<std::string>{"bounds"});
  }
}

TEST(Bounds, RouteFarAwayFailsWithoutGround) {
  Route route = example_route();
  for (RouteState& state : route.states) state.position.x() += 1e7;
  const Verdict verdict = check(example_site(), route);
  EXPECT_TRUE(broken_rules(verdict).contains("bounds"));
  EXPECT_EQ(find_margin(verdict, "terrain_clearance"), nullptr);
}

TEST(Bounds, TheEdgeItselfIsInside) {
  Site site = example_site();
  site.mission = {.start = {0, 0, 300}, .goal = {4000, 4000, 300}, .tolerance_m = 0};
  site.vehicle = {};
  site.threats.clear();
  const Route edge = make_route({{0, 0, 300}, {4000, 0, 300}, {4000, 4000, 300}});
  EXPECT_TRUE(check(site, edge).ok());
  EXPECT_NEAR(find_margin(check(site, edge), "terrain_clearance")->margin, 300 - 200 - 50, 1e-3);
}

}  // namespace
}  // namespace alate::test
