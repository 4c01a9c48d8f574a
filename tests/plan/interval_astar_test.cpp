// What lives on a track is what the check lets fly; and the flagship on sites where the answer is known.
#include <gtest/gtest.h>

#include <numeric>

#include "alate/check/check.hpp"
#include "alate/core/along_route.hpp"
#include "alate/core/stream.hpp"
#include "alate/data/scenario_file.hpp"
#include "search/interval/flight_path.hpp"
#include "search/interval/flight_profile.hpp"
#include "space/objective.hpp"
#include "support/drawn_track.hpp"
#include "support/fly.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

Site jacksboro_site() { return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml")); }

/// Random tracks over a site, each flown at an altitude that its label allows. Returns how many were.
int expect_lives_as_checked(Site site, std::uint64_t seed) {
  const World world(site);
  const BandWalk band(world);
  Stream random(seed, 0, 0);
  const Vec2 from = site.mission.start.head<2>();
  const Vec2 way = (site.mission.goal - site.mission.start).head<2>();
  int flown = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Vec2 place = from + random.uniform() * way;
    const auto ground = world.height(place);
    const double z = ground.value_or(0) + site.band.clearance_m + 60 * random.uniform();
    const PlanarPose start = planar_pose(place.x(), place.y(), 2 * kPi * random.uniform());
    const auto [track, label] = test::draw_track(band, start, z, random);
    if (track.size() < 3) continue;
    const PlanarPose end = track.back().end();
    const double z_end = label.low + random.uniform() * (label.high - label.low);
    site.mission = {.start = {place.x(), place.y(), z},
                    .heading_rad = kPi / 2 - start.heading,
                    .heading_given = true,
                    .goal = {end.x, end.y, z_end},
                    .tolerance_m = 0.001};
    const auto route =
        fly_track(FlightCost(band), track, site.mission.start, {.goal = site.mission.goal, .tolerance_m = 0});
    EXPECT_TRUE(route) << trial;
    if (!route) continue;
    ++flown;
    const Verdict verdict = check(site, *route);
    for (const Violation& broken : verdict.violations)
      ADD_FAILURE() << trial << ": " << broken.rule << " on leg " << broken.leg << ", " << broken.value << " of "
                    << broken.limit;
  }
  return flown;
}

TEST(IntervalFlight, KeepsWhatTheCheckAsksOverMountains) {
  EXPECT_GT(expect_lives_as_checked(jacksboro_site(), 1), 20);
}
TEST(IntervalFlight, KeepsWhatTheCheckAsksAtAWall) { EXPECT_GT(expect_lives_as_checked(test::ridge_site(), 2), 20); }
TEST(IntervalFlight, KeepsWhatTheCheckAsksInOpenAir) {
  EXPECT_GT(expect_lives_as_checked(test::open_air_site(), 3), 20);
}

/// An arc bulges beyond its chords: by however little, it must not come over unknown ground, nor leave the ground.
TEST(IntervalFlight, NoArcBulgesOverUnknownGround) {
  for (const bool voids : {true, false}) {
    Site site = test::ridge_site();
    auto& raster = std::get<HeightRaster>(site.ground);
    for (int row = 0; voids && row < raster.rows; ++row) {
      const int post = row * raster.columns + 30;
      raster.posts[static_cast<std::size_t>(post)] = std::numeric_limits<float>::quiet_NaN();
    }
    raster.voids = voids ? static_cast<std::size_t>(raster.rows) : 0;
    const double line_m = voids ? 2900 : 10000;
    const World world(site);
    const BandWalk band(world);
    const double radius_m = band.radius_m();
    int flown = 0;
    for (int offset_cm = -20; offset_cm <= 5; ++offset_cm)
      for (int phase = 0; phase < 20; ++phase) {
        const double angle = -kPi / 4 - 0.004 * phase;
        const Vec2 center(line_m + 0.01 * offset_cm - radius_m, 2000);
        const Vec2 at = center + radius_m * Vec2(std::cos(angle), std::sin(angle));
        AltitudeLabel label{.low = 60, .high = 200, .free = 60};
        const PlanarPose pose = planar_pose(at.x(), at.y(), angle + kPi / 2);
        if (!band.advance({Steering::left, pose, 2 * radius_m, radius_m}, label)) continue;
        ++flown;
        EXPECT_LT(offset_cm, 0) << "phase " << phase << (voids ? " at voids" : " at the edge");
      }
    EXPECT_GT(flown, 20);
  }
}

TEST(IntervalFlight, KeepsWhatTheCheckAsksOverHills) {
  Site site = test::ridge_site();
  PeakGround hills{.peaks = {}, .maximum = false, .area = {.min = {0, 0}, .max = {10000, 8000}}};
  for (int i = 0; i < 6; ++i)
    hills.peaks.push_back(
        {.center = {1500.0 * i + 500, 2200.0 + 300 * (i % 3)}, .height_m = 250, .slope_m = {700, 500}});
  site.ground = hills;
  EXPECT_GT(expect_lives_as_checked(site, 4), 20);
}

/// Wherever the last straight piece begins, by centimetres within the ball or without.
TEST(FlightEnd, IsCutWithinTheBallAndToNoCrumb) {
  const FlightEnd end{.goal = {0, 0, 100}, .tolerance_m = 20, .tilt_rad = 0.3};
  Stream random(1, 0, 0);
  for (int n = 0; n < 1000; ++n) {
    const double away = end.radius_m() + 0.6 * (random.uniform() - 0.5);
    const PlanarPiece arc{Steering::left, planar_pose(-300, 10, 0), 30, 70};
    Track track{arc, {Steering::straight, planar_pose(-away, 0, 0), away, 70}};
    cut_at_end(track, end);
    const bool dropped = track.size() == 1;
    EXPECT_EQ(dropped, away <= end.radius_m());
    if (dropped) continue;
    EXPECT_LE(-track.back().end().position().x(), end.radius_m() + 1e-9);
    EXPECT_GE(track.back().length_m, kLeastPiece_m);
  }
}

/// The sum that changes are judged by is that of the whole way worked out anew.
TEST(FlightPath, KnowsItsCostAfterManyChanges) {
  const World world(jacksboro_site());
  const BandWalk band(world);
  const FlightCost cost(band);
  Executor executor;
  RunContext run(executor, {});
  const ClimbField to_go(world, band.slopes(), run);
  IntervalAStar search(cost, to_go);
  const Mission& mission = world.site().mission;
  const FlightEnd end{.goal = mission.goal, .tolerance_m = mission.tolerance_m - 1e-3};
  const PlanarPose start = planar_pose(mission.start.x(), mission.start.y(), kPi / 2 - mission.heading_rad);
  const auto track =
      search.find({{start}, AltitudeLabel::at(mission.start.z())}, end, {.epsilon = 1.5, .bin_m = 100}, run);
  ASSERT_TRUE(track);
  FlightPath path(cost, end, *track, mission.start.z());
  Stream random(1, 0, 0);
  double before = path.cost();
  for (int round = 0; round < 20; ++round) {
    path.better(random, 50, run);
    EXPECT_LE(path.cost(), before + 1e-4);
    before = path.cost();
    const FlightPath anew(cost, path.end(), path.track(), mission.start.z());
    EXPECT_NEAR(path.cost(), anew.cost(), 1e-6 * path.cost());
    for (const PlanarPiece& piece : path.track()) EXPECT_GE(piece.length_m, kLeastPiece_m);
    const auto route = fly_track(cost, path.track(), mission.start, path.end());
    ASSERT_TRUE(route);
    EXPECT_TRUE(check(world.site(), *route).ok());
    // Slopes of up to 10 degrees make a flight longer than its track by up to 1.5 %.
    const double flown = Objective(world).route_cost(*route);
    EXPECT_GT(flown, path.cost() * 0.999);
    EXPECT_LT(flown, path.cost() * 1.016);
  }
}

TEST(IntervalAStar, RoundsAWallThroughItsGap) {
  const World world(test::ridge_site());
  const Plan plan = test::fly(world, {.name = "interval-astar"}, {.iterations = 20});
  ASSERT_EQ(plan.outcome, Outcome::feasible);
  // Over the gap's middle at the least: 4 km east and 4 km north, twice.
  EXPECT_GT(plan.cost, 2 * std::hypot(3900, 3900));
  EXPECT_LT(plan.cost, 2 * std::hypot(4000, 4000) * 1.05);
}

/// The cheapest way round Jacksboro's threats is some 26 500 m long, the shortest between their cores less.
TEST(IntervalAStar, KeepsTheRange) {
  Site site = jacksboro_site();
  const auto fly = [&](double range_m) {
    site.vehicle.range_m = range_m;
    return test::fly(site, {.name = "interval-astar"}, {.iterations = 20});
  };
  const double cheapest_m = flown_length(fly(60'000).route);
  const Plan shorter = fly(cheapest_m - 50);
  ASSERT_EQ(shorter.outcome, Outcome::feasible) << shorter.why;
  EXPECT_TRUE(check(site, shorter.route).ok());

  const Plan none = fly(25'900);
  EXPECT_EQ(none.outcome, Outcome::none_found);
  EXPECT_NE(none.why.find("vehicle.range_m is 25900"), std::string::npos) << none.why;

  const Plan proven = fly(25'000);
  EXPECT_EQ(proven.outcome, Outcome::infeasible_proven);
  EXPECT_NE(proven.why.find("no route is shorter than"), std::string::npos) << proven.why;
}

/// Threats ask for a way round that the range does not allow.
TEST(IntervalAStar, FliesThroughAThreatWhereTheRangeAsksForIt) {
  Site site = test::open_air_site();
  const Vec3 middle = (site.mission.start + site.mission.goal) / 2;
  const double straight_m = (site.mission.goal - site.mission.start).norm();
  site.threats = {{.name = "wide", .center = middle, .radius_m = straight_m / 3, .level = 1, .core_m = 0}};
  const auto fly = [&] { return test::fly(site, {.name = "interval-astar"}, {.iterations = 20}); };
  const double round_m = flown_length(fly().route);
  site.vehicle.range_m = std::midpoint(straight_m, round_m);
  for (const char* planner : {"interval-astar", "primitive-aco"}) {
    const Plan plan = test::fly(site, {.name = planner}, {.iterations = 20});
    ASSERT_EQ(plan.outcome, Outcome::feasible) << planner << ": " << plan.why;
    EXPECT_TRUE(check(site, plan.route).ok()) << planner;
  }
}

/// Bins follow the turn radius only as far as memory goes; an aircraft that can hardly turn has no way round the wall.
TEST(IntervalAStar, FliesTheTightestAndTheWidestTurns) {
  Site site = test::ridge_site();
  const auto fly = [&](double radius_m) {
    site.vehicle.turn_radius_m = radius_m;
    return test::fly(site, {.name = "interval-astar"}, {.iterations = 2, .time_limit_s = 20});
  };
  for (const double radius_m : {0.01, 0.5, 2000.0}) {
    const Plan plan = fly(radius_m);
    ASSERT_EQ(plan.outcome, Outcome::feasible) << radius_m;
    EXPECT_TRUE(check(site, plan.route).ok()) << radius_m;
  }
  EXPECT_TRUE(fly(1e6).route.empty());
}

/// Without a heading at the start, it begins as suits it best.
TEST(IntervalAStar, ChoosesAHeadingWhereNoneIsGiven) {
  Site site = test::open_air_site();
  site.threats.clear();
  site.mission.heading_given = false;
  site.mission.tolerance_m = 1;
  const World world(site);
  const Plan plan = test::fly(world, {.name = "interval-astar"}, {.iterations = 5});
  ASSERT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_LT(plan.cost, 1.001 * plan.lower_bound);
}

}  // namespace
}  // namespace alate
