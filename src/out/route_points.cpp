#include "out/route_points.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// `offset` from an arc's centre, turned clockwise.
Vec2 turned(const Vec2& offset, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * offset.x() + s * offset.y(), c * offset.y() - s * offset.x()};
}

double heading_at(const Site& site, const Route& route, std::size_t i) {
  if (i == 0) return site.mission.heading_rad;
  const RouteState& state = route.states[i];
  if (!state.arc) return heading_of(route.segment(i).b - route.segment(i).a);
  const Vec2 offset = state.position.head<2>() - state.arc->center;
  const double side = state.arc->angle_rad < 0 ? -1 : 1;
  return heading_of(side * Vec3{offset.y(), -offset.x(), 0});
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
    const RouteState& state = route.states[i];
    if (i > 0 && state.arc) {
      const Vec3 from = route.states[i - 1].position;
      const int pieces = static_cast<int>(std::ceil(std::abs(state.arc->angle_rad) / kChord));
      for (int k = 1; k < pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        const Vec2 at = state.arc->center + turned(from.head<2>() - state.arc->center, t * state.arc->angle_rad);
        line.emplace_back(at.x(), at.y(), from.z() + t * (state.position.z() - from.z()));
      }
    }
    line.push_back(state.position);
  }
  return line;
}

}  // namespace alate
