#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "alate/core/stream.hpp"
#include "alate/world/world.hpp"
#include "support/jacksboro.hpp"

namespace alate {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Lowest height above the ground at points `step_m` apart or closer; -infinity off the known ground.
double sampled_clearance(const Site& site, const Segment& leg, double step_m) {
  const int steps = std::max(1, static_cast<int>(std::ceil(leg.length() / step_m)));
  double lowest = kInfinity;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 at = leg.at(static_cast<double>(i) / steps);
    const auto ground = site.ground_height(at.head<2>());
    if (!ground || std::isnan(*ground)) return -kInfinity;
    lowest = std::min(lowest, at.z() - *ground);
  }
  return lowest;
}

/// A leg somewhere over the site, up to `longest_m` long, from 50 m under ground level to 300 m above.
Segment random_leg(const Site& site, Stream& stream, double longest_m) {
  const Box2& area = std::get<HeightRaster>(site.ground).area;
  const auto between = [&](double low, double high) { return low + stream.uniform() * (high - low); };
  const Vec2 from{between(area.min.x(), area.max.x()), between(area.min.y(), area.max.y())};
  const double heading = between(0, 2 * kPi);
  const Vec2 to = from + between(0, longest_m) * direction_of(heading).head<2>();
  const auto height = [&](const Vec2& xy) { return site.ground_height(xy).value_or(500) + between(-50, 300); };
  return {{from.x(), from.y(), height(from)}, {to.x(), to.y(), height(to)}};
}

/// Noise in all directions, 60 x 50 posts of 10 m, some of them void.
HeightRaster rough_raster(std::uint64_t seed, double void_share, const PostMap& map, const Box2& area) {
  HeightRaster raster{.columns = 60, .rows = 50, .map = map, .area = area, .cell_m = 10};
  Stream stream(seed, 1, 1);
  for (int i = 0; i < raster.columns * raster.rows; ++i) {
    const bool unknown = stream.uniform() < void_share;
    raster.posts.push_back(unknown ? std::nanf("") : static_cast<float>(80 * stream.uniform()));
    raster.voids += unknown ? 1U : 0U;
  }
  return raster;
}

PostMap plain_map() { return PostMap::affine({0, 0.1, 0, 49, 0, -0.1}); }

/// Knots that bend far more than any projection does.
PostMap bent_map() {
  constexpr int kColumns = 9;
  std::vector<Vec2> knots;
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < kColumns; ++i) knots.emplace_back(8.0 * i + 0.03 * j * j - 1, 50 - 7.5 * j + 0.02 * i * i);
  return PostMap::lattice({{0, 0}, {640, 560}}, 80, kColumns, knots);
}

World world_of(decltype(Site::ground) ground, Band band = {}, std::vector<Threat> threats = {}) {
  Site site;
  site.ground.swap(ground);
  site.band = band;
  site.threats = std::move(threats);
  return World(std::move(site));
}

/// `clearance` is never above dense samples, and hardly below them; voids and borders count on both sides.
void expect_sampling_agrees(const World& world, double longest_m, double step_m, double slack_m) {
  int known = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Stream stream(9, 0, i);
    const Segment leg = random_leg(world.site(), stream, i % 10 == 0 ? 10 * longest_m : longest_m);
    const double exact = world.clearance(leg);
    const double sampled = sampled_clearance(world.site(), leg, step_m);
    ASSERT_LE(exact, sampled + 1e-6) << i;
    if (exact == -kInfinity) continue;
    ++known;
    ASSERT_GE(exact, sampled - slack_m) << i;
  }
  EXPECT_GT(known, 200);
}

TEST(Clearance, IsNeverAboveDenseSamplingOnJacksboro) { expect_sampling_agrees(World(test::jacksboro()), 500, 1, 1.0); }

TEST(Clearance, IsNeverAboveDenseSamplingOnRoughGround) {
  const Box2 area{{0, 0}, {590, 490}};
  expect_sampling_agrees(world_of(rough_raster(1, 0, plain_map(), area)), 120, 0.05, 0.8);
  expect_sampling_agrees(world_of(rough_raster(2, 0.005, plain_map(), area)), 120, 0.05, 0.8);
  expect_sampling_agrees(world_of(rough_raster(3, 0, bent_map(), area)), 120, 0.05, 0.8);
  expect_sampling_agrees(world_of(rough_raster(4, 0.005, bent_map(), area)), 120, 0.05, 0.8);
}

TEST(Clearance, IsExactInASaddleBetweenPosts) {
  HeightRaster raster{.columns = 2,
                      .rows = 2,
                      .posts = {100, 0, 0, 100},
                      .map = PostMap::affine({0, 0.01, 0, 0, 0, 0.01}),
                      .area = {{0, 0}, {100, 100}},
                      .cell_m = 100};
  const World world = world_of(raster);
  EXPECT_NEAR(world.clearance({{0, 100, 200}, {100, 0, 200}}), 150, 1e-9);
  EXPECT_NEAR(world.clearance({{0, 0, 200}, {100, 100, 200}}), 100, 1e-9);
  EXPECT_NEAR(world.clearance({{50, 50, 200}, {50, 50, 120}}), 70, 1e-9);
}

TEST(Clearance, EndsAtTheOutermostPosts) {
  const World world = world_of(rough_raster(5, 0, plain_map(), {{0, 0}, {590, 490}}));
  EXPECT_GT(world.clearance({{0, 0, 500}, {590, 490, 500}}), 400);
  EXPECT_GT(world.clearance({{590, 490, 500}, {590, 0, 500}}), 400);
  EXPECT_EQ(world.clearance({{0, 0, 500}, {590.1, 490, 500}}), -kInfinity);
  EXPECT_EQ(world.clearance({{-1e9, 0, 500}, {1e9, 490, 500}}), -kInfinity);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world.clearance({{nan, 0, 500}, {590, 490, 500}}), -kInfinity);
  EXPECT_FALSE(world.is_free({{nan, 0, 500}, {590, 490, 500}}));
}

/// The band whose floor and roof are the leg's own lowest and highest clearance is free; any narrower is not.
TEST(Clearance, IsFreeDecidesAsClearanceDoes) {
  for (const PostMap& map : {plain_map(), bent_map()}) {
    const HeightRaster raster = rough_raster(6, 0.002, map, {{0, 0}, {590, 490}});
    const World open = world_of(raster);
    for (std::uint64_t i = 0; i < 400; ++i) {
      Stream stream(10, 0, i);
      const Segment leg = random_leg(open.site(), stream, i % 4 == 0 ? 600 : 100);
      const double lowest = open.clearance(leg);
      if (lowest == -kInfinity) {
        EXPECT_FALSE(open.is_free(leg));
        continue;
      }
      EXPECT_TRUE(world_of(raster, {.clearance_m = lowest}).is_free(leg)) << i;
      EXPECT_FALSE(world_of(raster, {.clearance_m = lowest + 2e-6}).is_free(leg)) << i;
    }
  }
}

TEST(Clearance, CeilingAboveGroundIsHeldAllAlong) {
  const HeightRaster raster = rough_raster(7, 0, plain_map(), {{0, 0}, {590, 490}});
  const World open = world_of(raster);
  for (std::uint64_t i = 0; i < 400; ++i) {
    Stream stream(11, 0, i);
    const Segment leg = random_leg(open.site(), stream, i % 4 == 0 ? 600 : 100);
    if (open.clearance(leg) == -kInfinity) continue;
    double highest = -kInfinity;
    for (int k = 0; k <= 5000; ++k) {
      const Vec3 at = leg.at(k / 5000.0);
      highest = std::max(highest, at.z() - *open.height(at.head<2>()));
    }
    const auto under = [&](double ceiling) {
      return world_of(raster, {.clearance_m = -1000, .ceiling_agl_m = ceiling}).is_free(leg);
    };
    EXPECT_FALSE(under(highest - 1e-3)) << i;
    EXPECT_TRUE(under(highest + 0.8)) << i;
  }
}

TEST(Clearance, WithoutGroundOnlyTheCeilingLimits) {
  const World world = world_of(std::monostate{}, {.ceiling_amsl_m = 100});
  EXPECT_EQ(world.clearance({{0, 0, 0}, {1, 1, 1}}), kInfinity);
  EXPECT_EQ(world.height({5, 5}), 0);
  EXPECT_TRUE(world.is_free({{0, 0, 100}, {1e6, 0, 50}}));
  EXPECT_FALSE(world.is_free({{0, 0, 100.1}, {1e6, 0, 50}}));
}

TEST(Clearance, CoresAreNotFree) {
  const World world = world_of(std::monostate{}, {},
                               {{.name = "radar", .center = {0, 0, 0}, .radius_m = 500, .level = 0.5, .core_m = 100}});
  EXPECT_FALSE(world.is_free({{-500, 99, 0}, {500, 99, 0}}));
  EXPECT_TRUE(world.is_free({{-500, 101, 0}, {500, 101, 0}}));
  EXPECT_TRUE(world.enters_core({{0, 0, 0}, {0, 0, 0}}));
  EXPECT_GT(world.exposure({{-500, 101, 0}, {500, 101, 0}}), 0);
}

class PeakClearance : public testing::TestWithParam<bool> {};

TEST_P(PeakClearance, IsNeverAboveTheTruthAndCloseToIt) {
  const PeakGround ground{.peaks = {{{300, 90}, 66, {40, 30}},
                                    {{160, 170}, 164, {70, 80}},
                                    {{350, 320}, 130, {50, 80}},
                                    {{220, 200}, -60, {50, 20}}},
                          .maximum = GetParam(),
                          .area = {{0, 0}, {500, 500}}};
  const auto world_with = [&](Band band) { return world_of(ground, band); };
  const World open = world_with({});
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream(12, 0, i);
    const auto point = [&]() -> Vec3 {
      return {500 * stream.uniform(), 500 * stream.uniform(), 300 * stream.uniform()};
    };
    const Vec3 a = point();
    const Segment leg{a, point()};
    double lowest = kInfinity;
    double highest = -kInfinity;
    for (int k = 0; k <= 4000; ++k) {
      const Vec3 at = leg.at(k / 4000.0);
      lowest = std::min(lowest, at.z() - ground.height(at.head<2>()));
      highest = std::max(highest, at.z() - ground.height(at.head<2>()));
    }
    const double found = open.clearance(leg);
    EXPECT_LE(found, lowest + 1e-9) << i;
    EXPECT_GE(found, lowest - 0.06) << i;
    EXPECT_TRUE(world_with({.clearance_m = found}).is_free(leg)) << i;
    EXPECT_FALSE(world_with({.clearance_m = found + 1e-5}).is_free(leg)) << i;
    EXPECT_FALSE(world_with({.clearance_m = -1000, .ceiling_agl_m = highest - 1e-3}).is_free(leg)) << i;
    EXPECT_TRUE(world_with({.clearance_m = -1000, .ceiling_agl_m = highest + 0.06}).is_free(leg)) << i;
  }
  EXPECT_EQ(open.clearance({{0, 0, 900}, {501, 0, 900}}), -kInfinity);
}

TEST_P(PeakClearance, NeedleHillIsFoundFromAfar) {
  const PeakGround needle{
      .peaks = {{{5000.3, 5000}, 8000, {0.001, 0.001}}}, .maximum = GetParam(), .area = {{0, 0}, {10000, 10000}}};
  EXPECT_NEAR(world_of(needle).clearance({{0, 5000, 9000}, {10000, 5000, 9000}}), 1000, 0.06);
}

INSTANTIATE_TEST_SUITE_P(SumAndMaximum, PeakClearance, testing::Bool());

}  // namespace
}  // namespace alate
