#include "space/taut_route.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/check/check.hpp"
#include "support/hand_made_sites.hpp"
#include "support/terrain_sites.hpp"

namespace alate {
namespace {

Route route_over(const std::vector<Vec3>& places) {
  Route route;
  for (const Vec3& place : places)
    route.states.push_back({.position = place, .leg = route.empty() ? LegKind::start : LegKind::straight});
  return route;
}

std::vector<Vec3> pulled(const Site& site, const std::vector<Vec3>& places, RunOptions options = {}) {
  const World world(site);
  Executor executor;
  RunContext run(executor, std::move(options));
  return TautRoute(world).pull(places, 500, run);
}

TEST(TautRoute, BecomesTheStraightLineWhereNothingIsInTheWay) {
  const Site site = test::flat_site();
  const Vec3 start = site.mission.start;
  const Vec3 goal = site.mission.goal;
  const auto places = pulled(site, {start, start + Vec3(3000, 2000, 300), start + Vec3(7000, -1000, 200), goal});
  EXPECT_EQ(places, (std::vector<Vec3>{start, goal}));
}

/// Round a hill on a plain: near the length of the two tangents and the arc between them.
TEST(TautRoute, HugsAHill) {
  Site site = test::flat_site();
  site.ground = PeakGround{.peaks = {{.center = {10000, 10000}, .height_m = 2500, .slope_m = {1500, 1500}}},
                           .maximum = false,
                           .area = {.min = {0, 0}, .max = {20000, 20000}}};
  const Vec3 start = site.mission.start;
  const Vec3 goal = site.mission.goal;
  const std::vector<Vec3> wide{start, start + Vec3(5000, 4000, 0), goal};
  const auto places = pulled(site, wide);
  EXPECT_TRUE(check(site, route_over(places)).ok());
  // At 500 m the hill with 100 m above it is a disc of radius 1500 sqrt(ln(2500 / 400)) = 2031 m.
  const double radius = 1500 * std::sqrt(std::log(2500.0 / 400));
  const double tangent = std::sqrt(25e6 - radius * radius);
  const double round = 2 * (tangent + radius * (kPi / 2 - std::acos(radius / 5000)));
  const World world(site);
  const double length = TautRoute(world).cost(places);
  EXPECT_LT(length, 1.01 * round);  // straight legs cannot follow the rim
  EXPECT_GT(length, 10000);
}

TEST(TautRoute, KeepsTheAircraftsLimits) {
  Site site = test::ridge_site();
  site.vehicle.turn_radius_m = 400;
  site.mission.heading_rad = radians(30);
  const Vec3 start = site.mission.start;
  const Vec3 goal = site.mission.goal;
  const std::vector<Vec3> places{
      start, start + Vec3(1500, 3000, 0), {4000, 6500, 150}, {6000, 6500, 150}, goal + Vec3(-1500, 2500, 0), goal};
  ASSERT_TRUE(check(site, route_over(places)).ok());
  const auto better = pulled(site, places);
  EXPECT_TRUE(check(site, route_over(better)).ok());
  const World world(site);
  const TautRoute taut(world);
  EXPECT_LT(taut.cost(better), taut.cost(places));
}

TEST(TautRoute, StopsWithWhatItHas) {
  std::stop_source source;
  source.request_stop();
  const Site site = test::flat_site();
  const std::vector<Vec3> places{site.mission.start, site.mission.start + Vec3(5000, 100, 0), site.mission.goal};
  EXPECT_EQ(pulled(site, places, {.stop = source.get_token()}), places);
}

}  // namespace
}  // namespace alate
