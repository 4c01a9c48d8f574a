#include "out/waypoints.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/geometry.hpp"

namespace alate {
namespace {

/// North for 300 m, a right turn of 100 degrees on a circle of 80 m, then straight on for 200 m; climbing evenly.
Route turning_route() {
  constexpr double kRadius = 80;
  const double angle = radians(100);
  const Vec2 center(kRadius, 300);
  const Vec2 end = center + kRadius * Vec2(-std::cos(angle), std::sin(angle));
  const Vec2 last = end + 200 * Vec2(std::sin(angle), std::cos(angle));
  Route route;
  route.states = {{.position = {0, 0, 100}, .leg = LegKind::start},
                  {.position = {0, 300, 130}, .leg = LegKind::straight},
                  {.position = {end.x(), end.y(), 144},
                   .leg = LegKind::arc,
                   .arc = Arc{.center = center, .radius_m = kRadius, .angle_rad = angle, .plane = {}}},
                  {.position = {last.x(), last.y(), 164}, .leg = LegKind::straight}};
  return route;
}

TEST(Waypoints, LeaveStraightRoutesAsTheyAre) {
  Route route;
  route.states = {{.position = {0, 0, 1}, .leg = LegKind::start}, {.position = {9, 0, 1}}, {.position = {9, 9, 2}}};
  const Route same = waypoints_of(route, radians(15));
  ASSERT_EQ(same.states.size(), 3U);
  EXPECT_EQ(same.states[1].position, route.states[1].position);
}

TEST(Waypoints, GoRoundAnArcInCornersThatItsCircleRounds) {
  const Route route = turning_route();
  const Route corners = waypoints_of(route, radians(15));
  ASSERT_EQ(corners.states.size(), 2U + 7U);  // 100 degrees in parts of at most 15
  EXPECT_EQ(corners.states.front().position, route.states.front().position);
  EXPECT_EQ(corners.states.back().position, route.states.back().position);
  const Arc& arc = *route.states[2].arc;
  for (std::size_t i = 1; i < corners.states.size(); ++i) {
    EXPECT_FALSE(corners.states[i].arc);
    // Every straight leg touches the circle or lies on a tangent of it.
    const Segment leg = corners.segment(i);
    const Vec2 along = (leg.b - leg.a).head<2>().normalized();
    const Vec2 off = arc.center - leg.a.head<2>();
    EXPECT_NEAR(std::abs(along.x() * off.y() - along.y() * off.x()), arc.radius_m, 1e-9) << i;
  }
  for (std::size_t i = 1; i + 1 < corners.states.size(); ++i) {
    const Vec3 before = corners.segment(i).b - corners.segment(i).a;
    const Vec3 after = corners.segment(i + 1).b - corners.segment(i + 1).a;
    EXPECT_NEAR(turn_between(before, after), radians(100.0 / 7), 1e-9) << i;
  }
}

TEST(Waypoints, KeepBendsInHeightAtTheEndsOfArcs) {
  Route route = turning_route();
  route.states[1].position.z() = 150;
  const Route corners = waypoints_of(route, radians(15));
  ASSERT_EQ(corners.states.size(), 2U + 7U + 2U);  // the crest, and the dip where the arc ends
  EXPECT_EQ(corners.states[1].position, route.states[1].position);
  EXPECT_EQ(corners.states[9].position, route.states[2].position);
}

TEST(Waypoints, KeepCorrectionPointsAtTheEndsOfArcs) {
  Route route = turning_route();
  route.states[1].point_id = 7;
  const Route corners = waypoints_of(route, radians(15));
  EXPECT_EQ(corners.states[1].point_id, 7);
}

}  // namespace
}  // namespace alate
