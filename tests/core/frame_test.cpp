#include "alate/core/frame.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

constexpr GeoPoint kJacksboro{36.378, -84.1263};

TEST(Frame, LocalHasNoPlaceOnEarth) {
  const Frame frame = Frame::local();
  EXPECT_TRUE(frame.is_local());
  EXPECT_EQ(frame.name(), "local");
  EXPECT_FALSE(frame.to_geo({0, 0}));
  EXPECT_FALSE(frame.from_geo(kJacksboro));
  EXPECT_EQ(frame.scale_at({0, 0}), 1);
}

TEST(Frame, UtmAgreesWithGeographicLib) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Stream stream(1, 0, i);
    const GeoPoint point{160 * stream.uniform() - 79, 360 * stream.uniform() - 180};
    int zone = 0;
    bool north = false;
    double x = 0;
    double y = 0;
    GeographicLib::UTMUPS::Forward(point.lat_deg, point.lon_deg, zone, north, x, y);
    const auto xy = Frame::utm(point).from_geo(point);
    ASSERT_TRUE(xy);
    EXPECT_NEAR(xy->x(), x, 1e-5);
    EXPECT_NEAR(xy->y(), y, 1e-5);
  }
}

TEST(Frame, ZonesOfBothHemispheresAndTheNorwegianExceptions) {
  EXPECT_EQ(Frame::utm(kJacksboro).name(), "EPSG:32616");
  EXPECT_EQ(Frame::utm({-35.4, 149.2}).name(), "EPSG:32755");
  EXPECT_EQ(Frame::utm({60, 4}).name(), "EPSG:32632");
  EXPECT_EQ(Frame::utm({89, 0}).name(), "EPSG:32661");
}

TEST(Frame, RoundTripsKeepMillimetres) {
  for (const Frame& frame : {Frame::utm(kJacksboro), Frame::at_origin(kJacksboro)}) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      Stream stream(2, 0, i);
      const GeoPoint point{36 + stream.uniform(), -84.5 + stream.uniform()};
      const auto xy = frame.from_geo(point);
      ASSERT_TRUE(xy);
      const auto back = frame.to_geo(*xy);
      ASSERT_TRUE(back);
      EXPECT_NEAR(back->lat_deg, point.lat_deg, 1e-9);
      EXPECT_NEAR(back->lon_deg, point.lon_deg, 1e-9);
    }
  }
}

TEST(Frame, OriginIsZeroAndDistancesAreTrue) {
  const Frame frame = Frame::at_origin(kJacksboro);
  EXPECT_LT(frame.from_geo(kJacksboro)->norm(), 1e-6);
  const GeoPoint near{36.40, -84.10};
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(kJacksboro.lat_deg, kJacksboro.lon_deg, near.lat_deg, near.lon_deg, metres);
  EXPECT_NEAR(frame.from_geo(near)->norm(), metres, 0.001);
  EXPECT_NEAR(frame.scale_at({0, 0}), 1, 1e-6);
}

TEST(Frame, NameOfAnOriginFrameReadsBackExactly) {
  const Frame frame = Frame::at_origin({36.123456789012345, -84.98765432109876});
  const Frame again = Frame::from_crs(frame.name());
  EXPECT_EQ(*frame.from_geo(kJacksboro), *again.from_geo(kJacksboro));
}

// swisstopo's fundamental point: the old observatory of Berne is (600 000, 200 000) in LV03.
TEST(Frame, SwissGridHasItsOriginInBerne) {
  const Frame frame = Frame::from_crs("EPSG:21781");
  const auto berne = frame.to_geo({600000, 200000});
  ASSERT_TRUE(berne);
  EXPECT_NEAR(berne->lat_deg, 46.951083, 2e-5);
  EXPECT_NEAR(berne->lon_deg, 7.438632, 2e-5);
}

TEST(Frame, UnknownAndGeographicSystemsAreRefused) {
  for (const char* crs : {"EPSG:999999", "nonsense", "", "EPSG:4326", "EPSG:4979", "EPSG:5773", "EPSG:4978",
                          "+proj=utm +zone=16 +units=us-ft +type=crs"})
    EXPECT_THROW(Frame::from_crs(crs), std::invalid_argument) << crs;
}

TEST(Frame, ScaleTellsUtmFromWebMercator) {
  const Frame utm = Frame::utm({48, 9});
  EXPECT_NEAR(utm.scale_at(*utm.from_geo({48, 9})), 0.9996, 1e-5);
  const Frame mercator = Frame::from_crs("EPSG:3857");
  EXPECT_NEAR(mercator.scale_at(*mercator.from_geo({48, 9})), 1 / std::cos(radians(48)), 0.01);
}

TEST(Frame, MayBeAskedFromManyThreads) {
  const Frame frame = Frame::utm(kJacksboro);
  const Vec2 expected = *frame.from_geo(kJacksboro);
  std::vector<int> wrong(4);
  std::vector<std::jthread> threads;
  for (int& count : wrong)
    threads.emplace_back([&] {
      for (int i = 0; i < 200; ++i) count += *frame.from_geo(kJacksboro) == expected ? 0 : 1;
    });
  threads.clear();
  for (const int count : wrong) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace alate
