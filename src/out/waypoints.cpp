#include "out/waypoints.hpp"

#include <algorithm>
#include <cmath>

#include "check/leg_shape.hpp"

namespace alate {

namespace {

constexpr double kCorner = 15 * kPi / 180;
constexpr double kChord = 5 * kPi / 180;

RouteState straight_to(const Vec3& position) { return {.position = position, .leg = LegKind::straight}; }

/// Corners k + 1/2 of the arc's n parts, moved out to where the tangents at the ends of the part meet.
void add_corners(const Route& route, std::size_t i, Route& out) {
  const Arc& arc = *route.states[i].arc;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc.angle_rad) / kCorner)));
  const double outward = 1 / std::cos(arc.angle_rad / (2 * count));
  for (int k = 0; k < count; ++k) {
    Vec3 corner = point_on_leg(route, i, (k + 0.5) / count);
    corner.head<2>() = arc.center + outward * (corner.head<2>() - arc.center);
    out.states.push_back(straight_to(corner));
  }
}

void add_chords(const Route& route, std::size_t i, Route& out) {
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(route.states[i].arc->angle_rad) / kChord)));
  for (int k = 1; k < count; ++k)
    out.states.push_back(straight_to(point_on_leg(route, i, static_cast<double>(k) / count)));
}

bool is_upright_arc(const RouteState& state) { return state.arc && !state.arc->plane; }

}  // namespace

Route waypoints_of(const Route& route) {
  Route out;
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    const RouteState& state = route.states[i];
    const bool last = i + 1 == route.states.size();
    if (i > 0 && is_upright_arc(state)) {
      add_corners(route, i, out);
    } else if (i > 0 && state.arc) {
      add_chords(route, i, out);
    }
    const bool touches_arc = is_upright_arc(state) || (!last && is_upright_arc(route.states[i + 1]));
    if (i > 0 && !last && touches_arc && !state.point_id) continue;
    RouteState waypoint = state;
    waypoint.arc.reset();
    if (i > 0) waypoint.leg = LegKind::straight;
    out.states.push_back(waypoint);
  }
  return out;
}

}  // namespace alate
