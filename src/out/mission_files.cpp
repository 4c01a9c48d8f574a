#include <fmt/core.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "alate/core/version.hpp"
#include "out/notes.hpp"
#include "out/route_files.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

// MAVLink: commands and frames; QGroundControl: AltMode of QGroundControlQmlGlobal.
constexpr int kNavWaypoint = 16;
constexpr int kDoChangeSpeed = 178;
constexpr int kFrameGlobal = 0;
constexpr int kFrameMission = 2;
constexpr int kFirmwarePx4 = 12;
constexpr int kVehicleFixedWing = 1;
constexpr int kAltitudeAbsolute = 2;
constexpr double kDefaultCruise = 15;  ///< QGroundControl's own; only for its time estimates.
constexpr double kDefaultHover = 5;

/// The start at ground height, or in the air where there is no ground.
double home_height(const Site& site) {
  const Vec3& start = site.mission.start;
  return start.z() - height_above_ground(site, start).value_or(0);
}

Json speed_item(double speed_mps) {
  return {{"autoContinue", true},
          {"command", kDoChangeSpeed},
          {"doJumpId", 1},
          {"frame", kFrameMission},
          {"params", {0, speed_mps, -1, 0, 0, 0, 0}},  // airspeed, throttle unchanged
          {"type", "SimpleItem"}};
}

Json waypoint_item(const RoutePoint& point, std::size_t jump_id) {
  const double height = point.state.position.z();
  return {{"AMSLAltAboveTerrain", nullptr},
          {"Altitude", height},
          {"AltitudeMode", kAltitudeAbsolute},
          {"autoContinue", true},
          {"command", kNavWaypoint},
          {"doJumpId", jump_id},
          {"frame", kFrameGlobal},
          {"params", {0, 0, 0, nullptr, point.geo->lat_deg, point.geo->lon_deg, height}},
          {"type", "SimpleItem"}};
}

Json items_of(const RouteToWrite& route) {
  Json items = Json::array();
  if (const auto& speed = route.result.site.vehicle.speed_mps) items.push_back(speed_item(*speed));
  for (const RoutePoint& point : route.waypoints) items.push_back(waypoint_item(point, items.size() + 1));
  return items;
}

}  // namespace

std::string route_plan(const RouteToWrite& route) {
  const Site& site = route.result.site;
  const GeoPoint& home = *route.points.front().geo;
  const Json mission{{"cruiseSpeed", site.vehicle.speed_mps.value_or(kDefaultCruise)},
                     {"firmwareType", kFirmwarePx4},
                     {"globalPlanAltitudeMode", kAltitudeAbsolute},
                     {"hoverSpeed", kDefaultHover},
                     {"items", items_of(route)},
                     {"plannedHomePosition", {home.lat_deg, home.lon_deg, home_height(site)}},
                     {"vehicleType", kVehicleFixedWing},
                     {"version", 2}};
  // QGroundControl passes over keys that it does not know.
  const Json plan{{"fileType", "Plan"},
                  {"alate", {{"version", version()}, {"datum", ground_note(site).datum}, {"notice", notice(site)}}},
                  {"geoFence", {{"circles", Json::array()}, {"polygons", Json::array()}, {"version", 2}}},
                  {"groundStation", "QGroundControl"},
                  {"mission", mission},
                  {"rallyPoints", {{"points", Json::array()}, {"version", 2}}},
                  {"version", 1}};
  return plan.dump(4, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string route_waypoints(const RouteToWrite& route) {
  const Site& site = route.result.site;
  std::string text = "QGC WPL 110\n";
  std::size_t row = 0;
  const auto add = [&](int command, double param2, double param3, const GeoPoint& at, double height) {
    fmt::format_to(std::back_inserter(text),
                   "{}\t{}\t{}\t{}\t0.000000\t{:.6f}\t{:.6f}\t0.000000\t{:.11f}\t{:.11f}\t{:.6f}\t1\n", row,
                   row == 0 ? 1 : 0, kFrameGlobal, command, param2, param3, at.lat_deg, at.lon_deg, height);
    ++row;
  };
  add(kNavWaypoint, 0, 0, *route.points.front().geo, home_height(site));
  if (const auto& speed = site.vehicle.speed_mps) add(kDoChangeSpeed, *speed, -1, {}, 0);
  for (const RoutePoint& point : route.waypoints) add(kNavWaypoint, 0, 0, *point.geo, point.state.position.z());
  return text;
}

std::size_t mission_items(const RouteToWrite& route) {
  return 1 + (route.result.site.vehicle.speed_mps ? 1 : 0) + route.waypoints.size();
}

}  // namespace alate
