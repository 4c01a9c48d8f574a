// One reader for each format. Each adds what it finds to the builder, faults included.
#pragma once

#include <string>

#include "data/route_builder.hpp"
#include "data/route_json.hpp"

namespace alate {

/// result.json: positions, kinds, arcs, actions and point ids.
void read_result(const Json& result, RouteBuilder& builder);

/// The scenario and the overrides that a result names.
void read_result_origin(const Json& result, RouteBuilder& builder);

/// A GeoJSON LineString [lon, lat, height], bare, in a feature or in a collection (RFC 7946).
void read_geojson(const Json& document, RouteBuilder& builder);

/// A QGroundControl plan, version 1 with mission version 2.
void read_plan(const Json& plan, RouteBuilder& builder);

/// "QGC WPL 110": one item a line, the first is home.
void read_waypoints(const std::string& text, RouteBuilder& builder);

/// route.csv, columns in any order.
void read_csv(const std::string& text, RouteBuilder& builder);

/// The one LineString of a KML file, altitudeMode absolute. GDAL reads the builder's file itself; `text` is what it
/// holds.
void read_kml(const std::string& text, RouteBuilder& builder);

}  // namespace alate
