#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "check/example.hpp"

namespace alate::test {
namespace {

/// Flies the actions with quaternions about the world images of the body axes, one after the other.
Route fly(const Site& site, const std::vector<AttitudeAction>& actions) {
  Route route = make_route({site.mission.start});
  Vec3 forward = direction_of(site.mission.heading_rad);
  Vec3 up = Vec3::UnitZ();
  const auto turn = [&](const Vec3& axis, double angle) {
    const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, axis));
    forward = q * forward;
    up = q * up;
  };
  for (const AttitudeAction& action : actions) {
    turn(forward, action.roll_rad);
    turn(forward.cross(up), action.pitch_rad);
    turn(up, -action.yaw_rad);
    const Vec3 at = route.states.back().position + *site.vehicle.step_m * forward;
    route.states.push_back({.position = at, .action = action});
  }
  return route;
}

std::vector<AttitudeAction> some_actions() {
  const double roll = radians(15);
  const double pitch = radians(4);
  const double yaw = radians(7.5);
  return {{0, 0, 0}, {roll, pitch, 0}, {0, 0, yaw}, {-roll, 0, yaw}, {0, -pitch, -yaw}, {roll, -pitch, yaw}};
}

TEST(Step, ReplayedRoutePasses) {
  const Verdict verdict = check(attitude_site(), fly(attitude_site(), some_actions()));
  EXPECT_TRUE(verdict.ok());
  ASSERT_NE(find_margin(verdict, "step"), nullptr);
  EXPECT_NEAR(find_margin(verdict, "step")->margin, 0, kRoundingNoise);
}

TEST(Step, SignsAreRightWingDownNoseUpNoseRight) {
  const Site site = attitude_site();
  const Route up = fly(site, {{0, radians(4), 0}});
  EXPECT_GT(up.states[1].position.z(), 1000);
  const Route right = fly(site, {{0, 0, radians(7.5)}});
  EXPECT_NEAR(degrees(heading_of(right.segment(1).b - right.segment(1).a)), 37.5, 1e-9);
  const Route banked = fly(site, {{radians(15), radians(4), 0}});
  EXPECT_GT(degrees(heading_of(banked.segment(1).b - banked.segment(1).a)), 30);
  for (const Route& route : {up, right, banked}) EXPECT_TRUE(check(site, route).ok());
}

TEST(Step, WrongActionBreaksStepOnly) {
  Route route = fly(attitude_site(), some_actions());
  route.states[3].action->yaw_rad = 0;
  const Verdict verdict = check(attitude_site(), route);
  EXPECT_EQ(broken_rules(verdict), std::set<std::string>{"step"});
  EXPECT_EQ(broken_legs(verdict), (std::set<std::size_t>{3, 4, 5, 6}));
}

TEST(Step, OneLegTooLongBreaksStepThere) {
  Route route = fly(attitude_site(), some_actions());
  const Vec3 longer = (route.segment(4).b - route.segment(4).a) / 300 * 1e-3;
  for (std::size_t i = 4; i < route.states.size(); ++i) route.states[i].position += longer;
  const Verdict verdict = check(attitude_site(), route);
  EXPECT_EQ(broken_rules(verdict), std::set<std::string>{"step"});
  EXPECT_EQ(broken_legs(verdict), std::set<std::size_t>{4});
  EXPECT_NEAR(verdict.violations.front().value, 1e-3, 1e-9);
}

TEST(Step, ActionThatTheScenarioDoesNotHaveBreaksStep) {
  std::vector<AttitudeAction> actions = some_actions();
  actions[2].yaw_rad = radians(5);
  const Verdict verdict = check(attitude_site(), fly(attitude_site(), actions));
  EXPECT_EQ(broken_legs(verdict), std::set<std::size_t>{3});
  EXPECT_EQ(verdict.violations.front().unit, "deg");
  EXPECT_NEAR(verdict.violations.front().value, 2.5, 1e-9);
}

TEST(Step, MissingActionsAreNotChecked) {
  const Verdict verdict = check(attitude_site(), make_route({{0, 0, 1000}, {0, 300, 1000}}));
  ASSERT_NE(find_not_checked(verdict, "step"), nullptr);
  EXPECT_EQ(find_not_checked(verdict, "step")->why, "the file carries no actions");
  EXPECT_TRUE(verdict.ok());
}

}  // namespace
}  // namespace alate::test
