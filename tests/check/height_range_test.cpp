// The exact walk against brute force.
#include "check/height_range.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "check/example.hpp"
#include "support/jacksboro.hpp"

namespace alate::test {
namespace {

struct Sampled {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

Sampled sample(const Segment& leg, double spacing, const std::function<double(const Vec2&)>& ground) {
  Sampled result;
  const int count = static_cast<int>(std::ceil(leg.length() / spacing));
  for (int i = 0; i <= count; ++i) {
    const Vec3 at = leg.at(static_cast<double>(i) / count);
    const double above = at.z() - ground(at.head<2>());
    result.lowest = std::min(result.lowest, above);
    result.highest = std::max(result.highest, above);
  }
  return result;
}

double between(Stream& random, double low, double high) { return low + (high - low) * random.uniform(); }

Segment random_leg(Stream& random, const Box2& area, double length) {
  const Vec3 a(between(random, area.min.x(), area.max.x()), between(random, area.min.y(), area.max.y()),
               between(random, 100, 400));
  Vec3 b = a + length * direction_of(between(random, 0, 2 * kPi));
  b.head<2>() = b.head<2>().cwiseMax(area.min).cwiseMin(area.max);
  b.z() = between(random, 100, 400);
  return {a, b};
}

HeightRaster rough_raster(std::uint64_t seed) {
  Stream random(seed, 1, 1);
  return make_raster(9, 7, [&](double, double) { return between(random, 0, 300); });
}

TEST(HeightRange, RasterAgreesWithCentimetreSampling) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Stream random(seed, 2, 2);
    const HeightRaster raster = rough_raster(seed);
    const Segment leg = random_leg(random, raster.area, between(random, 0.5, 250));
    const HeightRange range = height_range(raster, leg);
    const Sampled brute = sample(leg, 0.01, [&](const Vec2& xy) { return raster.height(xy).value(); });
    ASSERT_TRUE(range.lowest && range.highest);
    EXPECT_LE(range.lowest->height_m, brute.lowest + 1e-6);
    EXPECT_NEAR(range.lowest->height_m, brute.lowest, 0.1);
    EXPECT_GE(range.highest->height_m, brute.highest - 1e-6);
    EXPECT_NEAR(range.highest->height_m, brute.highest, 0.1);
    const Vec3& at = range.lowest->where;
    EXPECT_NEAR(at.z() - raster.height(at.head<2>()).value(), range.lowest->height_m, 1e-6);
  }
}

TEST(HeightRange, RotatedRasterAgreesWithSampling) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Stream random(seed, 3, 3);
    HeightRaster raster = rough_raster(seed);
    const double c = std::cos(0.3) / kCell;
    const double s = std::sin(0.3) / kCell;
    raster.map = PostMap::affine({3, c, s, 3, s, -c});
    raster.area = {Vec2(-900, -900), Vec2(900, 900)};
    const Segment leg = random_leg(random, {Vec2(-200, -200), Vec2(200, 200)}, 200);
    const Sampled brute = sample(leg, 0.01, [&](const Vec2& xy) { return raster.height(xy).value(); });
    EXPECT_LE(height_range(raster, leg).lowest->height_m, brute.lowest + 1e-6);
    EXPECT_NEAR(height_range(raster, leg).lowest->height_m, brute.lowest, 0.1);
  }
}

TEST(HeightRange, BentMapIsFollowedInShortCuts) {
  HeightRaster raster = make_raster(41, 41, [](double x, double y) { return 100 + 50 * std::sin(x / 90 + y / 70); });
  const double spacing = 250;
  std::vector<Vec2> knots;
  for (int j = 0; j <= 16; ++j) {
    for (int i = 0; i <= 16; ++i) {
      const double x = i * spacing / kCell;
      const double y = j * spacing / kCell;
      knots.emplace_back(x + 2e-4 * x * (40 - x), 40 - y - 1e-4 * x * y * (40 - y) / 40);
    }
  }
  raster.map = PostMap::lattice(raster.area, spacing, 17, knots);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Stream random(seed, 4, 4);
    const Segment leg = random_leg(random, {Vec2(300, 300), Vec2(3700, 3700)}, 3000);
    const Sampled brute = sample(leg, 0.05, [&](const Vec2& xy) { return raster.height(xy).value(); });
    EXPECT_NEAR(height_range(raster, leg).lowest->height_m, brute.lowest, 0.1);
    EXPECT_NEAR(height_range(raster, leg).highest->height_m, brute.highest, 0.1);
  }
}

TEST(HeightRange, RealTerrainInAnotherFrameAgreesWithSampling) {
  const Site site = jacksboro();
  const auto& raster = std::get<HeightRaster>(site.ground);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Stream random(seed, 6, 6);
    const Vec2 margin(2000, 2000);  // the posts lie askew in the box
    const Segment leg = random_leg(random, {raster.area.min + margin, raster.area.max - margin}, 3000);
    const Sampled brute = sample(leg, 0.05, [&](const Vec2& xy) { return raster.height(xy).value(); });
    EXPECT_NEAR(height_range(raster, leg).lowest->height_m, brute.lowest, 0.1);
    EXPECT_NEAR(height_range(raster, leg).highest->height_m, brute.highest, 0.1);
  }
}

TEST(HeightRange, SaddleBetweenPostsIsFound) {
  const HeightRaster raster = make_raster(2, 2, [](double x, double y) { return x == y ? 100.0 : 0.0; });
  const HeightRange diagonal = height_range(raster, {{0, 0, 200}, {100, 100, 200}});
  EXPECT_NEAR(diagonal.highest->height_m, 150, 1e-9);
  EXPECT_TRUE(diagonal.highest->where.isApprox(Vec3(50, 50, 200), 1e-9));
  EXPECT_NEAR(diagonal.lowest->height_m, 100, 1e-9);
}

TEST(HeightRange, PointAndVerticalLegs) {
  const HeightRaster raster = make_raster(3, 3, [](double x, double) { return x; });
  EXPECT_NEAR(height_range(raster, {{50, 50, 80}, {50, 50, 80}}).lowest->height_m, 30, 1e-6);
  const HeightRange vertical = height_range(raster, {{200, 200, 210}, {200, 200, 260}});
  EXPECT_NEAR(vertical.lowest->height_m, 10, 1e-6);
  EXPECT_NEAR(vertical.highest->height_m, 60, 1e-6);
}

TEST(HeightRange, OnlyThePartOverGroundCounts) {
  const HeightRaster raster = make_raster(3, 3, [](double, double) { return 100.0; });
  const HeightRange half = height_range(raster, {{100, 100, 200}, {-300, 100, 1000}});
  EXPECT_NEAR(half.lowest->height_m, 100, 1e-9);
  EXPECT_NEAR(half.highest->height_m, 300, 1);
  EXPECT_FALSE(height_range(raster, {{-1, -1, 0}, {-1, 500, 0}}).lowest);
}

TEST(HeightRange, VoidIsUnknownGround) {
  HeightRaster raster = make_raster(4, 2, [](double, double) { return 100.0; });
  raster.posts[0] = std::numeric_limits<float>::quiet_NaN();
  const HeightRange crossing = height_range(raster, {{50, 50, 200}, {250, 50, 200}});
  ASSERT_TRUE(crossing.unknown);
  EXPECT_LT(crossing.unknown->x(), 100);
  EXPECT_NEAR(crossing.lowest->height_m, 100, 1e-9);
  EXPECT_FALSE(height_range(raster, {{150, 50, 200}, {250, 50, 200}}).unknown);
}

TEST(HeightRange, HillsAreBoundedOnTheSafeSide) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Stream random(seed, 5, 5);
    PeakGround hills{.peaks = {}, .maximum = seed % 2 == 0, .area = {Vec2(0, 0), Vec2(5000, 5000)}};
    for (int i = 0; i < 5; ++i) {
      hills.peaks.push_back({.center = {between(random, 0, 5000), between(random, 0, 5000)},
                             .height_m = between(random, 50, 500),
                             .slope_m = {between(random, 200, 900), between(random, 200, 900)}});
    }
    const Segment leg = random_leg(random, hills.area, 4000);
    const HeightRange range = height_range(hills, leg);
    const Sampled brute = sample(leg, 0.1, [&](const Vec2& xy) { return hills.height(xy); });
    EXPECT_LE(range.lowest->height_m, brute.lowest + 1e-6);
    EXPECT_NEAR(range.lowest->height_m, brute.lowest, 0.06);
    EXPECT_GE(range.highest->height_m, brute.highest - 1e-6);
    EXPECT_NEAR(range.highest->height_m, brute.highest, 0.06);
  }
}

}  // namespace
}  // namespace alate::test
