// No flight costs less than the bottleneck, and what is said to be barred is.
#include "space/bound/bottleneck.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/data/scenario_file.hpp"
#include "space/bound/first_turn.hpp"
#include "support/rough_ground.hpp"

namespace alate {
namespace {

Site jacksboro_site() { return load_site(load_scenario(ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml")); }

Bottleneck bottleneck_of(const World& world, Voids voids = Voids::closed) {
  Executor executor;
  RunContext run(executor, {});
  return bottleneck(Problem(world), {.voids = voids}, run);
}

/// Whatever is free at a random place of a random box is open over the box.
int expect_open_where_free(const Site& site, std::uint64_t seed) {
  const World world(site);
  const OpenAir air(world.site());
  const Box2 area = air.area();
  Stream random(seed, 0, 0);
  int free = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec2 extent = area.max - area.min;
    const Vec2 corner = area.min + Vec2(random.uniform() * extent.x(), random.uniform() * extent.y());
    const Vec2 size = 300 * Vec2(random.uniform(), random.uniform());
    const Box2 box{.min = corner, .max = corner + size};
    const Vec2 at = corner + Vec2(random.uniform() * size.x(), random.uniform() * size.y());
    const auto ground = world.height(at);
    if (!ground || std::isnan(*ground)) continue;
    const Vec3 place(at.x(), at.y(), *ground + 1.2 * site.band.ceiling_agl_m.value_or(1000) * random.uniform());
    if (!world.is_free({place, place})) continue;
    ++free;
    EXPECT_TRUE(air.over(box).overlap({.low = place.z(), .high = place.z()})) << trial;
  }
  return free;
}

TEST(OpenAir, ForgetsNothingThatIsFree) {
  EXPECT_GT(expect_open_where_free(jacksboro_site(), 1), 5000);
  EXPECT_GT(expect_open_where_free(test::rough_site(2), 2), 5000);
  EXPECT_GT(expect_open_where_free(test::ridge_site(), 3), 5000);
}

/// Between start and goal on a plain of height 0 stands a ridge from edge to edge, 300 m high.
Site pass_site() {
  Site site = test::ridge_site();
  site.ground = test::raster_of(101, 81, 100, [](double x, double) { return std::abs(x - 2000) < 50 ? 300.0 : 0.0; });
  site.band = {.clearance_m = 50, .ceiling_agl_m = 400, .ceiling_amsl_m = {}};
  return site;
}

TEST(Bottleneck, ClimbsToThePass) {
  const World world(pass_site());
  const Bottleneck bound = bottleneck_of(world);
  EXPECT_FALSE(bound.barred);
  // 200 m of climb at 8 degrees begin 1000 m before the ridge and take 1423 m; behind it there is room to descend.
  const double climb = 200 / std::tan(radians(8));
  const double exact = climb + 7000 - 200 + 2 * 200;
  EXPECT_LT(bound.cost, exact + 200);
  EXPECT_GT(bound.cost, exact - 150);
}

TEST(Bottleneck, IsValidWhereverItIsStopped) {
  const World world(pass_site());
  Executor executor;
  std::stop_source source;
  source.request_stop();
  RunContext run(executor, {.stop = source.get_token()});
  const Bottleneck bound = bottleneck(Problem(world), {}, run);
  EXPECT_FALSE(bound.barred);
  EXPECT_LE(bound.cost, bottleneck_of(world).cost);
}

TEST(Bottleneck, SeesThatAWallBarsTheWay) {
  const World world(test::ridge_site(false));
  const Bottleneck bound = bottleneck_of(world);
  EXPECT_TRUE(bound.barred);
  EXPECT_FALSE(bound.at_goal);
  EXPECT_NEAR(bound.nearest.x(), 4650, 150);  // The wall begins at 4650 m.
  EXPECT_NEAR(bound.nearest.y(), 2000, 150);
  EXPECT_FALSE(bottleneck_of(World(test::ridge_site(true))).barred);
}

TEST(Bottleneck, SeesThatNothingIsOpenAtTheGoal) {
  Site site = test::ridge_site();
  site.mission.goal = {9000, 2000, 550};  // 150 m above the ceiling.
  site.mission.tolerance_m = 100;
  const Bottleneck bound = bottleneck_of(World(site));
  EXPECT_TRUE(bound.barred);
  EXPECT_TRUE(bound.at_goal);
  site.mission.tolerance_m = 200;
  EXPECT_FALSE(bottleneck_of(World(site)).barred);
}

TEST(Bottleneck, LeavesOpenWhatIsUnknown) {
  Site site = test::ridge_site(false);
  auto& raster = std::get<HeightRaster>(site.ground);
  for (int row = 0; row < raster.rows; ++row)
    raster.posts[static_cast<std::size_t>(row) * 101 + 50] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(bottleneck_of(World(site), Voids::closed).barred);
  EXPECT_TRUE(bottleneck_of(World(site), Voids::open).barred);  // Known walls on both sides.
  for (float& post : raster.posts)
    if (post > 0) post = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(bottleneck_of(World(site), Voids::closed).barred);
  EXPECT_FALSE(bottleneck_of(World(site), Voids::open).barred);
}

TEST(FirstTurn, KnowsHowFarAheadAWallMayStand) {
  Site site = test::ridge_site(false);
  site.vehicle.turn_radius_m = 300;
  const auto dead = [&](double x) {
    site.mission.start.x() = x;
    return dead_ahead(Problem(World(site)), Voids::closed);
  };
  // The wall rises from 0 to 1000 m between 4600 m and 4700 m; 550 m under the ceiling are reached 55 m on.
  EXPECT_TRUE(dead(4500));
  EXPECT_TRUE(dead(4400));
  EXPECT_FALSE(dead(4300));
  EXPECT_NEAR(dead(4500)->where.x(), 4610, 30);
  site.mission.heading_given = false;
  EXPECT_FALSE(dead(4500));
}

}  // namespace
}  // namespace alate
