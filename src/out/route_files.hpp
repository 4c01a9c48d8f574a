// A route as the files of other programs. Each function returns the whole text of one file.
#pragma once

#include <string>
#include <vector>

#include "alate/out/result.hpp"
#include "out/route_points.hpp"

namespace alate {

/// A route to write: the points of `result.plan.route`, and those that an autopilot is given.
struct RouteToWrite {
  const Result& result;
  std::vector<RoutePoint> points;
  std::vector<RoutePoint> waypoints;
};

/// One header line and one line a state. It holds no free text, so no cell needs escaping.
std::string route_csv(const RouteToWrite& route);

// The others need `on_earth(points)`.

/// RFC 7946: the route as a LineString of [lon, lat, height], then start, goal and threats as points. Datum and
/// notice are foreign members.
std::string route_geojson(const RouteToWrite& route);

/// OGC KML 2.2, heights absolute.
std::string route_kml(const RouteToWrite& route);

/// QGroundControl plan, version 1, heights above mean sea level (frame 0, AltitudeMode 2). Source: QGroundControl's
/// plan file format, and the keys its loaders require (MissionController, SimpleMissionItem, MissionItem).
std::string route_plan(const RouteToWrite& route);

/// "QGC WPL 110" as ArduPilot's ground stations read it: line 0 is home, frame 0. The format has no comments that all
/// of them accept, so it carries neither datum nor notice.
std::string route_waypoints(const RouteToWrite& route);

/// Items of the mission in either format, home included.
std::size_t mission_items(const RouteToWrite& route);

}  // namespace alate
