// The search from both ends: what it finds is one way, and it finds what one end alone takes long for.
#include "search/interval/both_ends.hpp"

#include <gtest/gtest.h>

#include "alate/core/stream.hpp"
#include "search/interval/flight_path.hpp"
#include "support/drawn_track.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

/// A goal, or a start, in a lane too narrow to turn in, open towards the far side only. Its walls are so thin that the
/// guide, whose cells are as wide as the aircraft's turns, sees none of them.
Site pocket_site(bool at_goal) {
  Site site = test::ridge_site();
  site.ground = test::raster_of(141, 81, 100, [at_goal](double x, double y) {
    const double along = at_goal ? x - 9000 : 5000 - x;
    const bool side = std::abs(std::abs(y - 4000) - 300) < 50 && along > -550 && along < 2050;
    const bool end = std::abs(y - 4000) < 350 && std::abs(along + 500) < 50;
    return side || end ? 1000.0 : 0.0;
  });
  site.vehicle.turn_radius_m = 250;
  site.mission.heading_rad = radians(at_goal ? 90 : 270);
  site.mission.start = {at_goal ? 1000.0 : 4800.0, 4000, 150};
  site.mission.goal = {at_goal ? 9200.0 : 13000.0, 4000, 150};
  return site;
}

/// All that a search needs, over a site.
struct Air {
  explicit Air(const Site& site)
      : world(site), band(world), cost(band), run(executor, {}), to_go(world, band.slopes(), run), to_start(home()) {}

  ClimbField home() {
    ClimbField field = to_go.homeward();
    field.grow(run);
    return field;
  }
  const Mission& mission() const { return world.site().mission; }
  FlightStart start() const {
    return {.poses = {planar_pose(mission().start.x(), mission().start.y(), kPi / 2 - mission().heading_rad)},
            .label = AltitudeLabel::at(mission().start.z())};
  }
  FlightEnd end() const { return {.goal = mission().goal, .tolerance_m = mission().tolerance_m - 1e-3}; }

  World world;
  BandWalk band;
  FlightCost cost;
  Executor executor;
  RunContext run;
  ClimbField to_go;
  ClimbField to_start;
};

constexpr IntervalSearchOptions kHasty{.epsilon = 8, .bin_m = 150, .alike_m = 6, .by_cost = false};

/// Its labels live, its pieces touch, and it leads into the goal's ball.
void expect_is_a_way(const Air& air, const Track& track) {
  AltitudeLabel label = air.start().label;
  PlanarPose at = air.start().poses[0];
  for (const PlanarPiece& piece : track) {
    EXPECT_LT((piece.start.position() - at.position()).norm(), 1e-6);
    EXPECT_LT(std::abs(std::remainder(piece.start.heading - at.heading, 2 * kPi)), 1e-8);
    EXPECT_TRUE(air.band.advance(piece, label));
    at = piece.end();
  }
  EXPECT_LT((at.position() - air.end().place()).norm(), air.end().radius_m() + 1e-6);
  EXPECT_TRUE(std::isfinite(FlightPath(air.cost, air.end(), track, air.mission().start.z()).cost()));
}

TEST(BothEnds, LeaveAndEnterPocketsSoonerThanOneEndAlone) {
  for (const bool at_goal : {true, false}) {
    Air air(pocket_site(at_goal));
    IntervalAStar search(air.cost, air.to_go);
    ASSERT_TRUE(search.find(air.start(), air.end(), kHasty, air.run));
    const std::uint64_t alone = search.expansions();
    BothEnds both(search, air.cost, air.to_start, 20);
    const auto track = both.find(air.start(), air.end(), kHasty, air.run);
    ASSERT_TRUE(track);
    expect_is_a_way(air, *track);
    if (!at_goal) continue;
    EXPECT_LT(2 * both.expansions(), alone);
  }
}

/// Whatever the ends, the way found is one.
TEST(BothEnds, FindWholeWaysOverMountains) {
  Site site = test::ridge_site();
  site.ground = test::raster_of(101, 81, 100, [](double x, double y) {
    return 300 * (std::sin(x / 700) * std::cos(y / 900) + 0.5 * std::sin((x + 2 * y) / 500));
  });
  site.band = {.clearance_m = 50, .ceiling_agl_m = 140, .ceiling_amsl_m = {}};
  Stream random(1, 0, 0);
  int found = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const auto place = [&] {
      const Vec2 at(1000 + 8000 * random.uniform(), 1000 + 6000 * random.uniform());
      return Vec3(at.x(), at.y(), *site.ground_height(at) + 60 + 70 * random.uniform());
    };
    site.mission.start = place();
    site.mission.goal = place();
    site.mission.heading_rad = 2 * kPi * random.uniform();
    Air air(site);
    IntervalAStar search(air.cost, air.to_go);
    const auto track = BothEnds(search, air.cost, air.to_start, 20).find(air.start(), air.end(), kHasty, air.run);
    if (!track) continue;
    ++found;
    expect_is_a_way(air, *track);
  }
  EXPECT_GT(found, 15);
}

TEST(BothEnds, GiveUpWhereAnEndHasNoWayOut) {
  Site site = pocket_site(true);
  auto& raster = std::get<HeightRaster>(site.ground);
  for (int row = 34; row < 47; ++row)
    for (int column = 104; column < 107; ++column) {
      const int post = row * raster.columns + column;
      raster.posts[static_cast<std::size_t>(post)] = 1000;
    }
  Air air(site);
  IntervalAStar search(air.cost, air.to_go);
  BothEnds both(search, air.cost, air.to_start, 20);
  EXPECT_FALSE(both.find(air.start(), air.end(), kHasty, air.run));
  // Not before all of the map is full, but the pocket.
  EXPECT_LT(both.expansions(), 100'000);
}

/// What flights the other way cost, in a world whose ends are exchanged.
TEST(ClimbField, KnowsTheWayBack) {
  Site site = pocket_site(true);
  site.vehicle.descent_rad = radians(20);
  site.mission.tolerance_m = 0;
  const Air air(site);
  std::swap(site.mission.start, site.mission.goal);
  std::swap(site.vehicle.climb_rad, site.vehicle.descent_rad);
  const Air back(site);
  Stream random(2, 0, 0);
  for (int k = 0; k < 200; ++k) {
    const Vec3 at(14000 * random.uniform(), 8000 * random.uniform(), 60 + 300 * random.uniform());
    EXPECT_DOUBLE_EQ(air.to_start(at), back.to_go(at));
  }
}

/// No search keeps what has come over unknown ground.
TEST(IntervalAStar, KeepsNoNodeThatIsNowhere) {
  Site site = test::ridge_site();
  auto& raster = std::get<HeightRaster>(site.ground);
  for (int row = 0; row < 60; ++row) {
    const int post = row * raster.columns + 30;
    raster.posts[static_cast<std::size_t>(post)] = std::numeric_limits<float>::quiet_NaN();
    ++raster.voids;
  }
  Air air(site);
  IntervalAStar search(air.cost, air.to_go);
  ASSERT_TRUE(search.find(air.start(), air.end(), {.epsilon = 1.2, .bin_m = 100}, air.run));
  for (const IntervalAStar::Node& node : search.nodes()) EXPECT_TRUE(std::isfinite(node.cost));
}

/// Altitudes that are said to be closed at a place are closed on every way through it.
TEST(BandWalk, OpensNoMoreThanItSays) {
  const Site site = test::ridge_site();
  const World world(site);
  const BandWalk band(world);
  Stream random(3, 0, 0);
  for (int k = 0; k < 500; ++k) {
    const PlanarPose at = planar_pose(1000 + 8000 * random.uniform(), 1000 + 6000 * random.uniform(), 7 * k);
    const auto [track, label] = test::draw_track(band, at, *world.height(at.position()) + 100, random);
    if (track.empty()) continue;
    const auto [floor, ceiling] = band.open_at(track.back().end().position());
    EXPECT_GE(label.low, floor);
    EXPECT_LE(label.high, ceiling);
  }
}

}  // namespace
}  // namespace alate
