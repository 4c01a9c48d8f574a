#include "alate/data/site.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/jacksboro.hpp"

namespace alate {
namespace {

TEST(Site, JacksboroIsFramedInItsUtmZone) {
  const Site site = test::jacksboro();
  EXPECT_EQ(site.frame.name(), "EPSG:32616");
  const auto& raster = std::get<HeightRaster>(site.ground);
  EXPECT_EQ(raster.columns, 403);
  EXPECT_EQ(raster.rows, 344);
  EXPECT_NEAR((site.mission.goal - site.mission.start).norm(), 25'800, 100);
  EXPECT_NEAR(site.mission.start.z() - *site.ground_height(site.mission.start.head<2>()), 120, 1e-9);
  EXPECT_FALSE(site.mission.heading_given);
  EXPECT_NEAR(site.mission.heading_rad, heading_of(site.mission.goal - site.mission.start), 1e-12);
}

}  // namespace
}  // namespace alate
