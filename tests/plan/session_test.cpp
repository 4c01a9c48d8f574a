// Flights replanned under way: every route passes the check of what the site has become.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/core/fault.hpp"
#include "alate/core/stream.hpp"
#include "alate/data/scenario_file.hpp"
#include "alate/plan/session.hpp"
#include "search/interval/track_of.hpp"
#include "space/flight/band_walk.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

Site jacksboro_site() { return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml")); }

Plan plan_with(Session& session, std::uint64_t iterations) {
  Executor executor;
  RunContext run(executor, {.iterations = iterations});
  return session.plan(run);
}

Plan replan_with(Session& session, const FlightState& state, const FlightChange& change, std::uint64_t iterations = 1) {
  Executor executor;
  RunContext run(executor, {.iterations = iterations});
  return session.replan(state, change, run);
}

void expect_passes(const Session& session, const Plan& plan) {
  ASSERT_FALSE(plan.route.empty()) << plan.why;
  EXPECT_EQ(plan.route.states.front().position, session.site().mission.start);
  const Verdict verdict = check(session.site(), plan.route);
  for (const Violation& broken : verdict.violations)
    ADD_FAILURE() << broken.rule << " on leg " << broken.leg << ": " << broken.value << " of " << broken.limit;
  EXPECT_NEAR(plan.cost, measure(session.site(), plan.route).cost, 1e-9 * plan.cost);
}

/// On the old route, this far ahead.
FlightChange threat_ahead(const Session& session, double at_m, double core_m) {
  std::vector<Threat> threats = session.site().threats;
  const Vec2 place = state_along(session.route(), at_m)->position.head<2>();
  threats.push_back({.name = "pop-up",
                     .center = {place.x(), place.y(), session.site().ground_height(place).value_or(0)},
                     .radius_m = 1.5 * core_m,
                     .level = 0.5,
                     .core_m = core_m});
  return {.threats = threats};
}

TEST(Session, PlansAsThePlannerDoes) {
  Session session(jacksboro_site());
  const Plan kept = plan_with(session, 3);
  const Plan plain = test::fly(jacksboro_site(), {.name = "interval-astar"}, {.iterations = 3});
  EXPECT_EQ(kept.cost, plain.cost);
  EXPECT_EQ(kept.counters, plain.counters);
}

TEST(Session, FliesOnWhereNothingHasChanged) {
  Session session(jacksboro_site());
  plan_with(session, 2);
  const Route old = session.route();
  Stream random(1, 0, 0);
  for (int trial = 0; trial < 40; ++trial) {
    session.follow(old);
    const double at = 0.95 * random.uniform() * flown_length(old);
    const Plan plan = replan_with(session, *state_along(old, at), {});
    expect_passes(session, plan);
    EXPECT_LT(plan.cost, 1.01 * measure(session.site(), rest_of(old, at)).cost + 1) << at;
  }
}

TEST(Session, RoundsThreatsThatPopUp) {
  Session session(jacksboro_site());
  plan_with(session, 2);
  for (const double core : {300.0, 700.0, 1100.0}) {
    const FlightState now = *state_along(session.route(), 1500);
    const FlightChange change = threat_ahead(session, 1500 + 2.5 * core + 1000, core);
    const Route rest = rest_of(session.route(), 1500);
    const Plan plan = replan_with(session, now, change);
    EXPECT_FALSE(check(session.site(), rest).ok());
    expect_passes(session, plan);
  }
}

TEST(Session, FollowsAGoalThatMoves) {
  Session session(jacksboro_site());
  plan_with(session, 2);
  const Vec3 old_goal = session.site().mission.goal;
  for (const Vec2& by : {Vec2(2500, 1500), Vec2(-1000, 3500)}) {
    const Vec2 place = old_goal.head<2>() + by;
    const Vec3 goal{place.x(), place.y(), session.site().ground_height(place).value() + 120};
    const Plan plan = replan_with(session, *state_along(session.route(), 3000), {.goal = goal});
    expect_passes(session, plan);
    EXPECT_EQ(session.site().mission.goal, goal);
  }
}

TEST(Session, GoesDownWithTheCeiling) {
  Session session(jacksboro_site());
  plan_with(session, 2);
  Band band = session.site().band;
  band.ceiling_agl_m = 170;
  int asked = 0;
  const Route old = session.route();
  for (double at = 2000; at < 20000; at += 3000) {
    session.follow(old);
    const FlightState now = *state_along(old, at);
    const double ground = session.site().ground_height(now.position.head<2>()).value();
    if (now.position.z() - ground > *band.ceiling_agl_m) continue;  // already above it
    ++asked;
    expect_passes(session, replan_with(session, now, {.band = band}));
  }
  EXPECT_GT(asked, 0);
}

TEST(Session, GetsBetterWithTimeAndGivesTheSameBits) {
  const auto flown = [](std::uint64_t iterations) {
    Session session(jacksboro_site());
    plan_with(session, 2);
    const FlightState now = *state_along(session.route(), 2000);
    const FlightChange change = threat_ahead(session, 6000, 900);
    return replan_with(session, now, change, iterations);
  };
  const Plan first = flown(1);
  const Plan later = flown(8);
  EXPECT_LE(later.cost, first.cost);
  EXPECT_EQ(later.cost, flown(8).cost);
}

/// Off the route, and with no route at all.
TEST(Session, LeadsBackAnAircraftThatHasDrifted) {
  Session session(jacksboro_site());
  FlightState now{.position = session.site().mission.start, .heading_rad = radians(240), .flown_m = 0};
  expect_passes(session, replan_with(session, now, {}));
  now = *state_along(session.route(), 2000);
  now.position.head<2>() += Vec2(60, 40);
  now.heading_rad += 0.3;
  expect_passes(session, replan_with(session, now, {}));
}

TEST(Session, SaysWhyThereIsNoRoute) {
  Session session(test::ridge_site());
  plan_with(session, 2);
  const Route old = session.route();
  const Vec3 goal = session.site().mission.goal;
  std::vector<Threat> threats = session.site().threats;
  threats.push_back({.name = "on the goal", .center = goal, .radius_m = 900, .level = 1, .core_m = 800});
  const Plan plan = replan_with(session, *state_along(old, 500), {.threats = threats}, 3);
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("of the goal"), std::string::npos) << plan.why;
  EXPECT_EQ(session.route().states.size(), old.states.size());
}

TEST(Session, SaysThatTheAircraftIsAboveTheNewCeiling) {
  Session session(test::ridge_site());
  plan_with(session, 2);
  Band band = session.site().band;
  const FlightState now = *state_along(session.route(), 500);
  band.ceiling_amsl_m = now.position.z() - 20;
  const Plan plan = replan_with(session, now, {.band = band}, 3);
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("the start ("), std::string::npos) << plan.why;
}

TEST(Session, RefusesWhatThePlannerRefuses) {
  Site site = test::open_air_site();
  site.vehicle.turn_radius_m = {};
  EXPECT_THROW(Session{site}, InputError);
}

TEST(TrackOf, IsTheTrackAgain) {
  const Site site = jacksboro_site();
  const Plan plan = test::fly(site, {.name = "interval-astar"}, {.iterations = 2});
  const Track track = track_of(plan.route, BandWalk(World(site)).radius_m());
  double planar = 0;
  for (std::size_t i = 1; i < plan.route.states.size(); ++i) {
    const auto& arc = plan.route.states[i].arc;
    planar += arc ? arc->radius_m * std::abs(arc->angle_rad) : plan.route.segment(i).planar_length();
  }
  EXPECT_NEAR(length_of(track), planar, 1e-6);
  EXPECT_LT(track.size(), plan.route.states.size());
  EXPECT_LT((track.back().end().position() - plan.route.states.back().position.head<2>()).norm(), 1e-6);
}

TEST(TrackOf, RoundsCorners) {
  Route route;
  route.states = {{.position = {0, 0, 100}, .leg = LegKind::start},
                  {.position = {1000, 0, 100}, .leg = LegKind::straight},
                  {.position = {1000, 1000, 100}, .leg = LegKind::straight}};
  const Track track = track_of(route, 80);
  ASSERT_GT(track.size(), 2U);
  for (std::size_t i = 1; i < track.size(); ++i) {
    const PlanarPose end = track[i - 1].end();
    EXPECT_LT((end.position() - track[i].start.position()).norm(), 1e-6);
    EXPECT_LT(std::abs(wrapped(end.heading - track[i].start.heading)), 1e-6);
  }
}

}  // namespace
}  // namespace alate
