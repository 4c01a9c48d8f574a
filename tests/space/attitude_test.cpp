#include "space/attitude.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "alate/core/stream.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

AttitudeState random_state(const AttitudeSpace& space, std::uint64_t seed, int steps) {
  Stream stream(seed, 0, 0);
  AttitudeState state = space.start();
  for (int i = 0; i < steps; ++i) state = space.next(state, stream.below(space.actions()));
  return state;
}

TEST(Attitude, CandidatesAreWhatNextLeadsTo) {
  const World world(test::konatowski_site(0.5, test::kLayoutC));
  const AttitudeSpace space(world, nullptr);
  Candidates candidates;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const AttitudeState state = random_state(space, seed, 5);
    space.expand(state, candidates);
    ASSERT_EQ(candidates.size(), space.actions());
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const AttitudeState next = space.next(state, k);
      EXPECT_LT((next.position - Vec3(candidates.x[k], candidates.y[k], candidates.z[k])).norm(), 1e-12);
      EXPECT_NEAR((next.position - state.position).norm(), 2, 1e-12);
      EXPECT_NEAR(candidates.cost[k], space.objective().leg_cost({state.position, next.position}), 1e-12);
      EXPECT_EQ(space.arrives(candidates, k), space.is_goal(next));
    }
  }
}

TEST(Attitude, PhysicalCandidatesCostWhatTheLegCosts) {
  const World world(test::open_air_site());
  const AttitudeSpace space(world, nullptr);
  Candidates candidates;
  int priced = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const AttitudeState state = random_state(space, seed, 12);
    space.expand(state, candidates);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (candidates.cost[k] == kInfinity) continue;
      const AttitudeState next = space.next(state, k);
      EXPECT_NEAR(candidates.cost[k], space.objective().leg_cost({state.position, next.position}), 1e-9);
      ++priced;
    }
  }
  EXPECT_GT(priced, 100);
}

/// Is the leg within the limits, by the words of the rules?
bool within_limits(const Vehicle& vehicle, const Segment& before, const Segment& leg, double slack) {
  const double angle = climb_angle(leg);
  if (angle > *vehicle.climb_rad + slack || angle < -*vehicle.descent_rad - slack) return false;
  const double theta = turn_between(before.b - before.a, leg.b - leg.a);
  const double usable = std::min(before.planar_length(), leg.planar_length()) / 2;
  return theta == 0 || usable / std::tan(theta / 2) >= *vehicle.turn_radius_m * (1 - slack);
}

TEST(Attitude, ExcludesWhatBreaksClimbDescentOrTurn) {
  Site site = test::konatowski_site(0.5, {});
  site.vehicle.turn_radius_m = 6;
  site.vehicle.climb_rad = radians(8);
  site.vehicle.descent_rad = radians(10);
  const World world(site);
  const AttitudeSpace space(world, nullptr);
  Candidates candidates;
  int allowed = 0;
  int excluded = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const AttitudeState from = random_state(space, seed, 3);
    const AttitudeState state = space.next(from, seed);
    space.expand(state, candidates);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Segment before{from.position, state.position};
      const Segment leg{state.position, {candidates.x[k], candidates.y[k], candidates.z[k]}};
      const bool in_k = candidates.cost[k] < kInfinity;
      EXPECT_TRUE(!in_k || within_limits(site.vehicle, before, leg, 1e-6));
      EXPECT_TRUE(in_k || !within_limits(site.vehicle, before, leg, -1e-6));
      ++(in_k ? allowed : excluded);
    }
  }
  EXPECT_GT(allowed, 50);
  EXPECT_GT(excluded, 50);
}

TEST(Attitude, AGivenHeadingLimitsTheFirstTurn) {
  Site site = test::konatowski_site(0.5, {});
  site.vehicle.turn_radius_m = 7;  // half of the first leg / tan(15 / 2 degrees) = 7.6, at 18 degrees only 6.3
  Candidates candidates;
  const auto count_allowed = [&](bool heading_given) {
    site.mission.heading_given = heading_given;
    const World world(site);
    const AttitudeSpace space(world, nullptr);
    space.expand(space.start(), candidates);
    return std::ranges::count_if(candidates.cost, [](double cost) { return cost < kInfinity; });
  };
  EXPECT_EQ(count_allowed(false), 125);
  EXPECT_LT(count_allowed(true), 125);
  EXPECT_GT(count_allowed(true), 60);
}

TEST(Attitude, AxesStaySquareOnLongRoutes) {
  const World world(test::konatowski_site(0.5, {}));
  const AttitudeSpace space(world, nullptr);
  const Mat3 attitude = random_state(space, 3, 20000).attitude;
  EXPECT_LT((attitude.transpose() * attitude - Mat3::Identity()).norm(), 1e-13);
  EXPECT_NEAR(attitude.determinant(), 1, 1e-13);
}

TEST(Attitude, StepLimitIsThePapersAndKeepsTheRange) {
  Site site = test::konatowski_site(0.5, {});
  const World world(site);
  EXPECT_EQ(AttitudeSpace(world, nullptr).step_limit(), 40U);
  EXPECT_EQ(AttitudeSpace(world, nullptr, {.step_limit = 17}).step_limit(), 17U);
  site.vehicle.range_m = 31;
  const World near(site);
  EXPECT_EQ(AttitudeSpace(near, nullptr).step_limit(), 15U);
}

}  // namespace
}  // namespace alate
