#include "space/correction_route.hpp"

#include <gtest/gtest.h>

#include "alate/check/check.hpp"

namespace alate {
namespace {

/// Start at the origin, three points, goal 9 km east.
Site site_of(TurnModel model) {
  Site site;
  site.mission.goal = {9000, 0, 1000};
  site.mission.start = {0, 0, 1000};
  Navigation& navigation = site.navigation.emplace();
  navigation.points = {{.id = 7, .position = {2000, 500, 1000}, .kind = PointKind::vertical},
                       {.id = 3, .position = {4000, -700, 1200}, .kind = PointKind::horizontal},
                       {.id = 5, .position = {4100, -700, 1200}, .kind = PointKind::vertical}};
  navigation.turn_model = model;
  navigation.turn_radius_m = 200;
  return site;
}

TEST(CorrectionRoute, StraightLegsVisitThePointsInOrder) {
  const auto [route, why] = route_through(site_of(TurnModel::none), std::vector{3, 7});
  EXPECT_EQ(why, "");
  ASSERT_EQ(route.states.size(), 4U);
  EXPECT_EQ(route.states[1].point_id, 3);
  EXPECT_EQ(route.states[2].point_id, 7);
  EXPECT_FALSE(route.states[3].point_id);
  EXPECT_EQ(route.states[3].position, Vec3(9000, 0, 1000));
}

TEST(CorrectionRoute, TurnsAreArcsThatTheCheckAccepts) {
  const Site site = site_of(TurnModel::arc_tangent);
  const auto [route, why] = route_through(site, std::vector{7, 3});
  EXPECT_EQ(why, "");
  ASSERT_EQ(route.states.size(), 6U);
  EXPECT_EQ(route.states[2].leg, LegKind::arc);
  EXPECT_EQ(route.states[4].leg, LegKind::arc);
  EXPECT_GT(measure(site, route).length_m,
            measure(site, route_through(site_of(TurnModel::none), std::vector{7, 3}).route).length_m);
  const Verdict verdict = check(site, route);
  for (const Violation& violation : verdict.violations) EXPECT_NE(violation.rule, "turn") << violation.value;
}

TEST(CorrectionRoute, SaysWhichLegCannotBeFlown) {
  const Site site = site_of(TurnModel::arc_tangent);
  EXPECT_EQ(route_through(site, std::vector{7, 9}).why, "there is no correction point 9");
  // From 3, flown towards the south-east, 5 lies inside the circle of the turn.
  const auto [route, why] = route_through(site, std::vector{7, 3, 5});
  EXPECT_TRUE(route.empty());
  EXPECT_EQ(why, "the leg from point 3 to point 5 cannot be flown: its end is too near for the turn");
}

}  // namespace
}  // namespace alate
