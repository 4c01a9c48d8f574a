// Small routes in every format, all over the same two or three places near Davos.
#pragma once

#include <map>
#include <string>

namespace alate::test {

inline const std::string kResultSample =
    R"({"schema": 1, "scenario": "davos.yaml", "overrides": ["vehicle.range_m=9000"],
 "route": [
  {"x_m": 0, "y_m": 0, "z_m": 1700, "lat": null, "lon": null, "leg": "start", "arc": null, "point_id": null,
   "actions": null},
  {"x_m": 0, "y_m": 300, "z_m": 1710, "leg": "straight", "point_id": 7,
   "actions": {"roll_deg": 15, "pitch_deg": -7.5, "yaw_deg": 90}},
  {"x_m": 100, "y_m": 400, "z_m": 1710, "leg": "arc",
   "arc": {"center_x_m": 100, "center_y_m": 300, "radius_m": 100, "angle_deg": 90}}]})";

inline const std::string kCsvSample =
    "leg,kind,x_m,y_m,z_m,lat,lon,amsl_m,agl_m,heading_deg,point_id\n"
    "0,start,0,0,1700,,,1700,,0,\r\n"
    "1,straight,0,300.5,1.71e3,,,1710,,45,7\n"
    "2,arc,100,400,1710,,,1710,,90,\n";

inline const std::string kPlanSample = R"({"fileType": "Plan", "version": 1, "mission": {"version": 2,
 "plannedHomePosition": [46.8, 9.84, 1500], "items": [
  {"type": "SimpleItem", "command": 22, "frame": 3, "params": [0, 0, 0, null, 46.81, 9.84, 50]}, // above home
  {"type": "SimpleItem", "command": 178, "frame": 2, "params": [0, 20, -1, 0, 0, 0, 0]},
  {"type": "ComplexItem", "complexItemType": "survey"},
  {"type": "SimpleItem", "command": 17, "frame": 0, "params": [0, 0, 80, null, 46.82, 9.85, 1800]}]}})";

inline const std::string kWaypointsSample =
    "QGC WPL 110\r\n"
    "0\t1\t0\t16\t0\t0\t0\t0\t46.80\t9.84\t1500\t1\r\n"
    "1\t0\t3\t22\t15\t0\t0\t0\t0\t0\t80\t1\r\n"
    "2\t0\t0\t16\t0\t0\t0\t0\t46.81000000\t9.84\t1550.0\t1\r\n"
    "3 0 3 16 0 0 0 0 46.82 9.85 300 1\n";

inline const std::string kKmlSample = R"(<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2"><Document><name>route</name>
<Placemark><name>Route</name><LineString><altitudeMode>absolute</altitudeMode>
<coordinates>9.84,46.81,1550 9.85,46.82,1800 </coordinates></LineString></Placemark>
<Placemark><name>Start</name><Point><coordinates>9.84,46.81,1550</coordinates></Point></Placemark>
</Document></kml>
)";

inline const std::string kGeojsonSample = R"({"type": "FeatureCollection", "datum": "EGM96", "features": [
 {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [9.84, 46.81, 0]}},
 {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
  "coordinates": [[9.84, 46.81, 1550], [9.85, 46.82, 1800]]}}]})";

/// Text by file name.
inline const std::map<std::string, std::string> kRouteSamples{
    {"result.json", kResultSample},        {"route.csv", kCsvSample}, {"route.plan", kPlanSample},
    {"route.waypoints", kWaypointsSample}, {"route.kml", kKmlSample}, {"route.geojson", kGeojsonSample}};

/// The text with the first `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text + "SAMPLE LACKS " + from : text.replace(at, from.size(), to);
}

}  // namespace alate::test
