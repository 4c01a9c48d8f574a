#include "out/waypoints.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <vector>

#include "check/leg_shape.hpp"

namespace alate {

namespace {

constexpr double kChord = 5 * kPi / 180;

RouteState straight_to(const Vec3& position) { return {.position = position, .leg = LegKind::straight}; }

/// Corners k + 1/2 of the arc's n parts, moved out to where the tangents at the ends of the part meet.
void add_corners(const Route& route, std::size_t i, double corner_rad, Route& out) {
  const Arc& arc = *route.states[i].arc;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc.angle_rad) / corner_rad)));
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

/// Neither turns nor bends in height there, to what a planner keeps above the ground to spare.
bool is_needless(const RouteState& state, const Vec3& before, const Vec3& after) {
  constexpr double kLeast_m = 5e-3;
  if (state.point_id || state.leg == LegKind::start) return false;
  const Vec3 along = after - before;
  const double part = std::clamp((state.position - before).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (before + part * along - state.position).norm() < kLeast_m;
}

}  // namespace

Route waypoints_of(const Route& route, double corner_rad) {
  Route out;
  std::vector<std::size_t> touching;
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    const RouteState& state = route.states[i];
    const bool last = i + 1 == route.states.size();
    if (i > 0 && is_upright_arc(state)) {
      add_corners(route, i, corner_rad, out);
    } else if (i > 0 && state.arc) {
      add_chords(route, i, out);
    }
    const bool touches_arc = is_upright_arc(state) || (!last && is_upright_arc(route.states[i + 1]));
    if (touches_arc && !last) touching.push_back(out.states.size());
    RouteState waypoint = state;
    waypoint.arc.reset();
    if (i > 0) waypoint.leg = LegKind::straight;
    out.states.push_back(waypoint);
  }
  for (const std::size_t k : touching | std::views::reverse)
    if (k > 0 && is_needless(out.states[k], out.states[k - 1].position, out.states[k + 1].position))
      out.states.erase(out.states.begin() + static_cast<std::ptrdiff_t>(k));
  return out;
}

}  // namespace alate
