// States in flight, against arcs and legs worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "alate/core/along_route.hpp"

namespace alate {
namespace {

/// 100 m north, a quarter turn to the right on 50 m climbing 10 m, 40 m east.
Route bent_route() {
  Route route;
  route.states = {{.position = {0, 0, 100}, .leg = LegKind::start},
                  {.position = {0, 100, 100}, .leg = LegKind::straight},
                  {.position = {50, 150, 110}, .leg = LegKind::arc, .arc = Arc{{50, 100}, 50, kPi / 2, {}}},
                  {.position = {90, 150, 110}, .leg = LegKind::straight}};
  return route;
}

const double kArc_m = std::hypot(50 * kPi / 2, 10);

TEST(AlongRoute, CountsArcsAsTheyAreFlown) { EXPECT_NEAR(flown_length(bent_route()), 140 + kArc_m, 1e-9); }

TEST(AlongRoute, TellsPlaceAndHeading) {
  const Route route = bent_route();
  const auto north = state_along(route, 30);
  ASSERT_TRUE(north);
  EXPECT_LT((north->position - Vec3(0, 30, 100)).norm(), 1e-9);
  EXPECT_NEAR(north->heading_rad, 0, 1e-12);
  const auto half = state_along(route, 100 + kArc_m / 2);
  ASSERT_TRUE(half);
  const double spoke = 50 * std::sqrt(0.5);
  EXPECT_LT((half->position - Vec3(50 - spoke, 100 + spoke, 105)).norm(), 1e-9);
  EXPECT_NEAR(half->heading_rad, kPi / 4, 1e-9);
  const auto end = state_along(route, flown_length(route));
  ASSERT_TRUE(end);
  EXPECT_LT((end->position - Vec3(90, 150, 110)).norm(), 1e-9);
  EXPECT_NEAR(end->heading_rad, kPi / 2, 1e-12);
}

TEST(AlongRoute, RestAndBeginMakeTheWhole) {
  const Route route = bent_route();
  for (const double at : {0.0, 12.5, 100.0, 120.0, 100 + kArc_m, 190.0}) {
    const Route begin = begin_of(route, at);
    const Route rest = rest_of(route, at);
    EXPECT_NEAR(flown_length(begin), at, 1e-9);
    EXPECT_NEAR(flown_length(begin) + flown_length(rest), flown_length(route), 1e-9);
    EXPECT_LT((begin.states.back().position - rest.states.front().position).norm(), 1e-9);
    EXPECT_EQ(rest.states.front().leg, LegKind::start);
    const auto there = state_along(route, at + 5);
    const auto same = state_along(rest, 5);
    if (!there || !same) continue;
    EXPECT_LT((there->position - same->position).norm(), 1e-9);
    EXPECT_NEAR(there->heading_rad, same->heading_rad, 1e-9);
  }
}

TEST(AlongRoute, SaysNothingWhereThereIsNoFlight) {
  const Route route = bent_route();
  EXPECT_FALSE(state_along(route, -1));
  EXPECT_FALSE(state_along(route, 1000));
  EXPECT_FALSE(state_along(route, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(state_along({}, 0));
  Route upright = route;
  upright.states[1].position = {0, 0, 200};
  EXPECT_FALSE(state_along(upright, 50));
  EXPECT_TRUE(rest_of(route, 1000).empty());
}

}  // namespace
}  // namespace alate
