// A route with what every writer needs about each state: its place on Earth, height above ground, heading.
#pragma once

#include <optional>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

struct RoutePoint {
  RouteState state;
  std::optional<GeoPoint> geo;  ///< Nothing in a local frame.
  std::optional<double> agl_m;  ///< Nothing where there is no ground or it is unknown.
  double heading_rad = 0;       ///< On arriving; at the start, the mission's.
};

std::vector<RoutePoint> route_points(const Site& site, const Route& route);

/// Is every point known in WGS 84, so that others can fly or map the route? False without points.
bool on_earth(const std::vector<RoutePoint>& points);

/// Height above ground; nothing where there is no ground or it is unknown.
std::optional<double> height_above_ground(const Site& site, const Vec3& position);

/// The route as a line to draw: arcs become chords of at most five degrees.
std::vector<Vec3> drawn_line(const Route& route);

}  // namespace alate
