#include "out/route_points.hpp"

#include <algorithm>
#include <cmath>

#include "check/leg_shape.hpp"

namespace alate {

namespace {

double heading_at(const Site& site, const Route& route, std::size_t i) {
  return i == 0 ? site.mission.heading_rad : heading_of(last_direction(route, i));
}

}  // namespace

std::optional<double> height_above_ground(const Site& site, const Vec3& position) {
  const auto ground = site.ground_height(position.head<2>());
  if (!ground || !std::isfinite(*ground)) return std::nullopt;
  return position.z() - *ground;
}

std::vector<RoutePoint> route_points(const Site& site, const Route& route) {
  std::vector<RoutePoint> points;
  points.reserve(route.states.size());
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    const Vec3& position = route.states[i].position;
    points.push_back({.state = route.states[i],
                      .geo = site.frame.to_geo(position.head<2>()),
                      .agl_m = height_above_ground(site, position),
                      .heading_rad = heading_at(site, route, i)});
  }
  return points;
}

bool on_earth(const std::vector<RoutePoint>& points) {
  return !points.empty() && std::ranges::all_of(points, [](const RoutePoint& p) { return p.geo.has_value(); });
}

std::vector<Vec3> drawn_line(const Route& route) {
  constexpr double kChord = 5 * kPi / 180;
  std::vector<Vec3> line;
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    const auto& arc = route.states[i].arc;
    if (i > 0 && arc) {
      const int pieces = static_cast<int>(std::ceil(std::abs(arc->angle_rad) / kChord));
      for (int k = 1; k < pieces; ++k) line.push_back(point_on_leg(route, i, static_cast<double>(k) / pieces));
    }
    line.push_back(route.states[i].position);
  }
  return line;
}

}  // namespace alate
