#include "alate/data/site.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/jacksboro.hpp"
#include "support/shared_data.hpp"

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

/// All faults of a scenario that must not load, one a line.
std::string refusal(const Scenario& scenario) {
  try {
    load_site(scenario);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "the scenario loaded";
  return "";
}

void expect_refused(const Scenario& scenario, std::initializer_list<const char*> parts) {
  const std::string text = refusal(scenario);
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(Site, FaultsCarryTheirMark) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.terrain->dem = "nowhere.tif";
  scenario.marks["terrain.dem"] = {.file = "a.yaml", .line = 5, .column = 8};
  expect_refused(scenario, {"a.yaml:5:8: terrain.dem: no such file (got nowhere.tif)"});
}

TEST(Site, BothEndsAreJudgedAtOnce) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.start.place.agl_m = -5;
  scenario.goal.place.agl_m = 20;
  expect_refused(scenario,
                 {"start: lies under the ground", "goal: is lower than the clearance (got 20.00, allowed >= 50"});
}

TEST(Site, OutsideTheTerrainItsExtentIsTold) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.goal.place.lat_deg = 36.6;
  expect_refused(scenario, {"goal: lies outside the terrain", "lat 36.16000 to 36.44583, lon -84.41333 to -84.07833"});
}

TEST(Site, WrongHemisphereIsOutsideTheTerrain) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.goal.place.lon_deg = 84.3825;
  expect_refused(scenario, {"goal: lies outside the terrain", "lon -84.41333 to -84.07833"});
  scenario.start.place.lon_deg = 84.1263;
  expect_refused(scenario, {"start: lies outside the terrain", "goal: lies outside the terrain"});
}

TEST(Site, CeilingsHoldForStartAndGoal) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.terrain->ceiling_agl_m = 100;
  expect_refused(scenario, {"start: is above the ceiling (got 120.00, allowed <= 100.00 m above ground)", "goal:"});
  scenario.terrain->ceiling_agl_m.reset();
  scenario.terrain->ceiling_amsl_m = 300;
  expect_refused(scenario, {"start: is above the ceiling", "m above sea level"});
}

TEST(Site, ExactlyAtTheClearanceIsNoFault) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.start.place.agl_m = scenario.goal.place.agl_m = 50;
  EXPECT_NO_THROW(load_site(scenario));
}

TEST(Site, StartEqualToGoalIsFine) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.goal.place = scenario.start.place;
  EXPECT_EQ(load_site(scenario).mission.heading_rad, 0);
}

TEST(Site, CoresKeepStartAndGoalOut) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.threats.push_back(
      {.name = "<script>", .lat_deg = 36.378, .lon_deg = -84.1263, .agl_m = 0, .radius_m = 900, .core_m = 200});
  CylinderSpec cylinder{.lat_deg = 36.2733, .lon_deg = -84.3825, .floor_m = 0, .top_m = 2000};
  scenario.threats.push_back({.name = "tower", .cylinder = cylinder, .radius_m = 900, .core_m = 200});
  expect_refused(scenario,
                 {"start: lies in the core of threat '<script>'", "goal: lies in the core of threat 'tower'"});
}

TEST(Site, ThreatsArePlacedAboveGround) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.threats.push_back({.name = "radar", .lat_deg = 36.3, .lon_deg = -84.2, .agl_m = 10, .radius_m = 900});
  const Site site = load_site(scenario);
  const Vec3 center = site.threats.at(0).center;
  EXPECT_NEAR(center.z(), *site.ground_height(center.head<2>()) + 10, 1e-9);
}

TEST(Site, FrameFaultsNameTheFrame) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.frame.crs = "EPSG:4326";
  expect_refused(scenario, {"frame.crs"});
  scenario.frame.crs = "EPSG:999999";
  expect_refused(scenario, {"frame.crs"});
  scenario.frame.crs = "EPSG:3857";
  expect_refused(scenario, {"frame.crs: a metre on the ground at the start is 1.2", "allowed 0.99 to 1.01"});
}

TEST(Site, PlacesNeedAHeightAndAPlace) {
  Scenario scenario;
  scenario.frame.local = true;
  scenario.start.place = {.position_m = {{0, 0, 100}}};
  scenario.goal.place = {.lat_deg = 1, .lon_deg = 1, .amsl_m = 100};
  expect_refused(scenario, {"goal: a local frame has no latitude"});
  scenario.frame.local = false;
  scenario.start.place = {.lat_deg = 1, .lon_deg = 1};
  scenario.goal.place = {.lat_deg = 1, .lon_deg = 1, .agl_m = 100};
  expect_refused(scenario, {"start: has no height", "goal: a height above ground needs a terrain"});
}

TEST(Site, PeaksAreBoundedByTheirExtent) {
  Scenario scenario;
  scenario.frame.local = true;
  scenario.terrain =
      TerrainSpec{.peaks = {{{500, 500}, 300, {100, 100}}}, .extent_m = {{1000, 1000}}, .clearance_m = 10};
  scenario.start.place = {.position_m = {{100, 100, 50}}};
  scenario.goal.place = {.position_m = {{1100, 900, 50}}};
  expect_refused(scenario, {"goal: lies outside the terrain", "x 0.0 to 1000.0"});
  scenario.goal.place = {.position_m = {{900, 900, 50}}};
  EXPECT_NEAR(*load_site(scenario).ground_height({500, 500}), 300, 1e-9);
}

TEST(Site, AnglesAreRadiansInside) {
  Scenario scenario = test::jacksboro_scenario();
  scenario.start.heading_deg = 225;
  scenario.vehicle = {.climb_deg = 8, .step_m = 300, .roll_deg = {-15, 0}, .pitch_deg = {0}, .yaw_deg = {15}};
  const Site site = load_site(scenario);
  EXPECT_TRUE(site.mission.heading_given);
  EXPECT_DOUBLE_EQ(site.mission.heading_rad, 1.25 * kPi);
  EXPECT_DOUBLE_EQ(*site.vehicle.climb_rad, radians(8));
  EXPECT_FALSE(site.vehicle.descent_rad);
  EXPECT_TRUE(site.vehicle.has_attitude_steps());
  EXPECT_DOUBLE_EQ(site.vehicle.roll_rad.at(0), radians(-15));
}

TEST(Site, VoidsAreUnknownGroundForStartAndGoal) {
  ALATE_NEEDS_SHARED_DATA("terrain/srtm3/N46E008.tif");
  Scenario scenario;
  scenario.terrain = TerrainSpec{.dem = test::shared_data("terrain/srtm3/N46E008.tif").string()};
  scenario.frame.origin = GeoPoint{46.5, 8.5};
  scenario.start.place = {.lat_deg = 46.5, .lon_deg = 8.5, .amsl_m = 5000};
  scenario.goal.place = scenario.start.place;
  const Site site = load_site(scenario);
  EXPECT_EQ(site.warnings.size(), 1U);
  const auto& raster = std::get<HeightRaster>(site.ground);
  const auto hole =
      std::ranges::find_if(raster.posts, [](float post) { return std::isnan(post); }) - raster.posts.begin();
  const auto row = hole / 1201;
  scenario.goal.place.lat_deg = 47 - static_cast<double>(row) / 1200 - 1e-5;
  scenario.goal.place.lon_deg = 8 + static_cast<double>(hole % 1201) / 1200 + 1e-5;
  expect_refused(scenario, {"goal: lies on unknown ground"});
}

}  // namespace
}  // namespace alate
