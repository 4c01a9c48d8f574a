#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "alate/core/stream.hpp"
#include "support/jacksboro.hpp"

namespace alate {
namespace {

TEST(PostMap, AffineIsExact) {
  const PostMap map = PostMap::affine({-10, 0.1, 0.02, 20, 0.01, -0.1});
  EXPECT_TRUE(map({100, 50}).isApprox(Vec2(-10 + 10 + 1, 20 + 1 - 5), 1e-12));
  EXPECT_EQ(map.straight_until({0, 0}, {1e6, 1e6}, 0), 1);
}

TEST(PostMap, LatticeOfJacksboroIsTheProjection) {
  const Site site = test::jacksboro();
  const auto& raster = std::get<HeightRaster>(site.ground);
  const Vec2 cell{0.335833 / 403, 0.286667 / 344};
  double worst = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Stream stream(3, 0, i);
    const Vec2 post{402 * stream.uniform(), 343 * stream.uniform()};
    const GeoPoint geo{36.446250 - (post.y() + 0.5) * cell.y(), -84.413750 + (post.x() + 0.5) * cell.x()};
    worst = std::max(worst, (raster.map(*site.frame.from_geo(geo)) - post).norm());
  }
  EXPECT_LT(worst, 0.001);
}

TEST(PostMap, LegsAreStraightBetweenCuts) {
  const Site site = test::jacksboro();
  const auto& raster = std::get<HeightRaster>(site.ground);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream(4, 0, i);
    const auto point = [&]() -> Vec2 {
      return raster.area.min + Vec2(stream.uniform(), stream.uniform()).cwiseProduct(raster.area.max - raster.area.min);
    };
    const Vec2 a = point();
    const Vec2 b = i % 2 == 0 ? point() : Vec2(a + Vec2(0, 5));
    int pieces = 0;
    for (double t = 0; t < 1; ++pieces) {
      const double end = raster.map.straight_until(a, b, t);
      ASSERT_GT(end, t);
      ASSERT_LE(end, 1);
      const auto at = [&](double s) { return raster.map(a + s * (b - a)); };
      EXPECT_LT((at(0.3 * t + 0.7 * end) - (0.3 * at(t) + 0.7 * at(end))).norm(), 1e-8);
      t = end;
    }
    EXPECT_LT(pieces, 200);
  }
}

TEST(PostMap, OutsideTheLatticeThereAreNoPosts) {
  const Site site = test::jacksboro();
  EXPECT_FALSE(site.ground_height({0, 0}));
  EXPECT_FALSE(site.ground_height({1e300, std::numeric_limits<double>::quiet_NaN()}));
}

}  // namespace
}  // namespace alate
