#include <gtest/gtest.h>

#include <regex>

#include "mission_loaders.hpp"
#include "out/route_files.hpp"
#include "support.hpp"
#include "support/shared_data.hpp"

namespace alate {
namespace {

using Json = nlohmann::json;
using test::Flight;
using test::to_write;

TEST(RoutePlan, IsTakenByQGroundControl) {
  Flight flight;
  flight.find_route();
  EXPECT_EQ(test::qgroundcontrol_refuses_plan(route_plan(to_write(flight))), "");
}

TEST(RoutePlan, FliesTheRouteAboveSeaLevel) {
  Flight flight;
  flight.find_route();
  const RouteToWrite route = to_write(flight);
  const Json mission = Json::parse(route_plan(route))["mission"];
  EXPECT_EQ(mission["firmwareType"], 12);
  EXPECT_EQ(mission["vehicleType"], 1);
  EXPECT_EQ(mission["globalPlanAltitudeMode"], 2);
  EXPECT_EQ(mission["cruiseSpeed"], 20);
  EXPECT_NEAR(mission["plannedHomePosition"][2], 150 - *route.points[0].agl_m, 1e-9);
  const Json& items = mission["items"];
  ASSERT_EQ(items.size(), 5U);
  EXPECT_EQ(items[0]["command"], 178);
  EXPECT_EQ(items[0]["params"][1], 20);
  for (std::size_t i = 0; i < items.size(); ++i) EXPECT_EQ(items[i]["doJumpId"], i + 1);
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    const Json& item = items[i + 1];
    EXPECT_EQ(item["command"], 16);
    EXPECT_EQ(item["frame"], 0);
    EXPECT_EQ(item["AltitudeMode"], 2);
    EXPECT_NEAR(item["params"][4], route.points[i].geo->lat_deg, 1e-12);
    EXPECT_NEAR(item["params"][5], route.points[i].geo->lon_deg, 1e-12);
    EXPECT_EQ(item["params"][6], route.points[i].state.position.z());
  }
}

TEST(RoutePlan, SetsNoSpeedThatNobodyGave) {
  Flight flight;
  flight.find_route();
  flight.site.vehicle.speed_mps.reset();
  const Json mission = Json::parse(route_plan(to_write(flight)))["mission"];
  EXPECT_EQ(mission["items"].size(), 4U);
  EXPECT_EQ(mission["items"][0]["command"], 16);
}

TEST(RouteWaypoints, AreTakenByArduPilotsGroundStations) {
  Flight flight;
  flight.find_route();
  const std::string text = route_waypoints(to_write(flight));
  EXPECT_EQ(test::qgroundcontrol_refuses_waypoints(text), "");
  EXPECT_EQ(test::mavproxy_refuses_waypoints(text), "");
}

TEST(RouteWaypoints, BeginAtHomeOnTheGround) {
  Flight flight;
  flight.find_route();
  const RouteToWrite route = to_write(flight);
  std::istringstream stream(route_waypoints(route));
  std::string line;
  std::getline(stream, line);
  std::getline(stream, line);
  static const std::regex kHome(R"(0\t1\t0\t16(\t0\.000000){4}\t\d+\.\d{11}\t\d+\.\d{11}\t([\d.-]+)\t1)");
  std::smatch home;
  ASSERT_TRUE(std::regex_match(line, home, kHome)) << line;
  EXPECT_NEAR(std::stod(home[2]), 150 - *route.points[0].agl_m, 1e-6);
  std::getline(stream, line);
  EXPECT_TRUE(line.starts_with("1\t0\t0\t178\t0.000000\t20.000000\t-1.000000\t")) << line;
  std::size_t lines = 2;
  while (std::getline(stream, line)) {
    EXPECT_TRUE(line.starts_with(std::to_string(lines) + "\t0\t0\t16\t")) << line;
    ++lines;
  }
  EXPECT_EQ(lines, mission_items(route));
}

TEST(MissionLoaders, RefuseWhatIsWrong) {
  Flight flight;
  flight.find_route();
  const Json good = Json::parse(route_plan(to_write(flight)));
  const auto refused = [&](const char* pointer, const Json& value) {
    Json plan = good;
    plan[Json::json_pointer(pointer)] = value;
    return !test::qgroundcontrol_refuses_plan(plan.dump()).empty();
  };
  EXPECT_TRUE(refused("/version", 2));
  EXPECT_TRUE(refused("/mission/version", 1));
  EXPECT_TRUE(refused("/mission/items/1/params", Json::array({0, 0, 0})));
  EXPECT_TRUE(refused("/mission/items/1/autoContinue", 1));
  EXPECT_TRUE(refused("/mission/items/1/Altitude", "high"));
  EXPECT_TRUE(refused("/mission/plannedHomePosition", Json::array({46, 9})));
  EXPECT_FALSE(test::qgroundcontrol_refuses_waypoints("QGC WPL 110\n# comment\n").empty());
  EXPECT_FALSE(test::mavproxy_refuses_waypoints("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t46\t9\n").empty());
}

TEST(MissionLoaders, JudgeTheSamplesOfOthersAsTheyShould) {
  ALATE_NEEDS_SHARED_DATA("missions");
  const auto plan = [](const std::string& name) {
    return test::qgroundcontrol_refuses_plan(test::read_text(test::shared_data("missions/" + name)));
  };
  for (const char* good : {"qgc/davosdorf_mission.plan", "qgc/terrain_benchmark_mission.plan",
                           "qgc/qgroundcontrol_sample.plan", "qgc/qgroundcontrol_sample_with_survey.plan",
                           "px4/vtol_mission_with_land_start.plan", "px4/multicopter_mission_geofence_avoid.plan"})
    EXPECT_EQ(plan(good), "") << good;
  for (const char* bad :
       {"qgc/qgroundcontrol_sample_without_mission.plan", "qgc/qgroundcontrol_sample_wrong_mission_version.plan",
        "qgc/qgroundcontrol_sample_wrong_overall_version.plan", "px4/fw_mission.plan"})
    EXPECT_NE(plan(bad), "") << bad;
  for (const char* good : {"ardupilot/KalaupapaCanyonRun.txt", "ardupilot/ap-terrain.txt"})
    EXPECT_EQ(test::mavproxy_refuses_waypoints(test::read_text(test::shared_data(std::string("missions/") + good))), "")
        << good;
}

}  // namespace
}  // namespace alate
