// No flight costs less than what is said to be the least, and where none is said to exist none does.
#include "plan/flight/flight_bound.hpp"

#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "search/interval/any_angle_bound.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/objective.hpp"
#include "support/drawn_track.hpp"
#include "support/fly.hpp"
#include "support/rough_ground.hpp"

namespace alate {
namespace {

Site jacksboro_site() { return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml")); }

double bound_of(const World& world) {
  Executor executor;
  RunContext run(executor, {});
  Plan plan;
  note_bound(Problem(world), BoundEffort::quick, run, plan);
  EXPECT_NE(plan.outcome, Outcome::infeasible_proven) << plan.why;
  return plan.lower_bound;
}

/// Told nothing of the route, so that only the proof keeps it low.
double tight_bound_of(const World& world, double most) {
  Executor executor;
  RunContext run(executor, {});
  return any_angle_bound(Problem(world), {.most = most, .most_cells = 5000}, run);
}

/// Random flights, each compared with the bound of the problem of getting from where it begins to where it ends.
int expect_below_drawn_flights(Site site, std::uint64_t seed, int trials) {
  const World world(site);
  Stream random(seed, 0, 0);
  const Vec2 way = (site.mission.goal - site.mission.start).head<2>();
  int flown = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Vec2 place = site.mission.start.head<2>() + random.uniform() * way;
    const double z = world.height(place).value_or(0) + site.band.clearance_m + 60 * random.uniform();
    const PlanarPose start = planar_pose(place.x(), place.y(), 2 * kPi * random.uniform());
    const BandWalk band(world);
    const auto [track, label] = test::draw_track(band, start, z, random);
    if (track.size() < 3) continue;
    const PlanarPose end = track.back().end();
    Site other = site;
    other.mission = {.start = {place.x(), place.y(), z},
                     .heading_rad = kPi / 2 - start.heading,
                     .heading_given = true,
                     .goal = {end.x, end.y, label.low + random.uniform() * (label.high - label.low)},
                     .tolerance_m = 0.001};
    const auto route =
        fly_track(FlightCost(band), track, other.mission.start, {.goal = other.mission.goal, .tolerance_m = 0});
    if (!route || !check(other, *route).ok()) continue;
    ++flown;
    const double cost = measure(other, *route).cost;
    EXPECT_LE(bound_of(World(other)), cost) << trial;
    EXPECT_LE(tight_bound_of(World(other), 3 * cost), cost) << trial;
  }
  return flown;
}

TEST(FlightBound, IsBelowFlightsOverMountains) { EXPECT_GT(expect_below_drawn_flights(jacksboro_site(), 1, 60), 20); }
TEST(FlightBound, IsBelowFlightsOverRoughGround) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    EXPECT_GT(expect_below_drawn_flights(test::rough_site(seed), seed, 20), 5) << seed;
}
TEST(FlightBound, IsBelowFlightsAtAWall) { EXPECT_GT(expect_below_drawn_flights(test::ridge_site(), 3, 60), 20); }

TEST(FlightBound, IsBelowRoutesThatArePlanned) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Site site = test::rough_site(seed);
    const Plan plan = test::fly(site, {.name = "interval-astar"}, {.iterations = 3, .time_limit_s = 1});
    if (plan.route.empty()) continue;
    ++found;
    EXPECT_TRUE(check(site, plan.route).ok()) << seed;
    EXPECT_LE(plan.lower_bound, measure(site, plan.route).cost) << seed;
  }
  EXPECT_GT(found, 2);
}

/// A plain with two walls that cannot be flown over, the first open in the north and the second in the south.
TEST(AnyAngleBound, WindsBetweenWalls) {
  Site site = test::ridge_site();
  site.ground = test::raster_of(101, 81, 100, [](double x, double y) {
    const bool first = std::abs(x - 3000) < 150 && y < 6050;
    const bool second = std::abs(x - 7000) < 150 && y > 1950;
    return first || second ? 1000.0 : 0.0;
  });
  site.mission.goal.y() = 6000;
  const World world(site);
  const double shortest = 2 * std::hypot(2000, 4000) + std::hypot(4000, 4000) - site.mission.tolerance_m;
  const double bound = tight_bound_of(world, 3 * shortest);
  EXPECT_LT(bound, shortest + 200);
  EXPECT_GT(bound, shortest - 600);
  const Plan quick = test::fly(world, {.name = "interval-astar"}, {.iterations = 2});
  const Plan tight =
      test::fly(world, {.name = "interval-astar", .settings = {{.name = "bound", .text = "tight"}}}, {.iterations = 2});
  EXPECT_GT(tight.lower_bound, 1.2 * quick.lower_bound);
  EXPECT_LE(tight.lower_bound, tight.cost);
}

Plan interval_plan(const Site& site) { return test::fly(site, {.name = "interval-astar"}, {.iterations = 10}); }

TEST(FlightBound, ProvesThatAWallBarsTheWay) {
  const Plan plan = interval_plan(test::ridge_site(false));
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("part the start from the goal"), std::string::npos) << plan.why;
}

TEST(FlightBound, ProvesNothingAcrossUnknownGround) {
  Site site = test::ridge_site(false);
  auto& raster = std::get<HeightRaster>(site.ground);
  for (float& post : raster.posts) {
    if (post <= 0) continue;
    post = std::numeric_limits<float>::quiet_NaN();
    ++raster.voids;
  }
  const Plan plan = interval_plan(site);
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_NE(plan.why.find("without data"), std::string::npos) << plan.why;
}

TEST(FlightBound, ProvesThatNothingIsOpenAtTheGoal) {
  Site site = test::ridge_site();
  site.mission.goal = {9000, 2000, 550};  // 150 m above the ceiling.
  site.mission.tolerance_m = 100;
  const Plan plan = interval_plan(site);
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("within 100 m of the goal"), std::string::npos) << plan.why;
}

TEST(FlightBound, ProvesThatTheStartHeadsIntoAWall) {
  Site site = test::ridge_site();
  site.vehicle.turn_radius_m = 300;
  site.mission.start = {4500, 2000, 150};
  const Plan plan = interval_plan(site);
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("closer than a turn"), std::string::npos) << plan.why;
  site.mission.heading_rad = radians(270);
  EXPECT_EQ(interval_plan(site).outcome, Outcome::feasible);
}

}  // namespace
}  // namespace alate
