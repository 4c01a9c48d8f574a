// Routes and missions from files of other programs, and our own results.
#pragma once

#include <string>
#include <vector>

#include "alate/core/frame.hpp"
#include "alate/core/route.hpp"

namespace alate {

/// A route read from a file, with what the file says about its origin.
struct RouteFile {
  Route route;
  std::string format;                  ///< "result", "csv", "plan", "waypoints", "kml" or "geojson".
  std::string scenario;                ///< Only results: the scenario they were planned for; empty elsewhere.
  std::vector<std::string> overrides;  ///< Only results.
  std::vector<std::string> notes;      ///< What was passed over, e.g. items without a position.
};

/// Reads result.json, route.csv, .plan (QGroundControl), .waypoints (QGC WPL 110), a KML or a GeoJSON line.
/// Heights must be above mean sea level. Throws InputError with every fault.
RouteFile load_route(const std::string& file, const Frame& frame);

/// The scenario (and overrides) a result.json was planned for; empty for any other file. Throws InputError.
RouteFile peek_result(const std::string& file);

}  // namespace alate
