#include "check/flight.hpp"

#include <cmath>

#include "check/leg_shape.hpp"

namespace alate {

namespace {

constexpr double kFarthest = 1e8;    // Metres; twice round the Earth.
constexpr double kLargestArc = 1e6;  // Metres; keeps an arc's pieces below 10^5.
constexpr double kMostTurns = 4 * kPi;
constexpr double kUnit = 1e-9;  // Slack of a unit vector's length.

bool usable(const ArcPlane& plane) {
  return std::abs(plane.center_z_m) <= kFarthest && std::abs(plane.normal.norm() - 1) <= kUnit;
}

bool usable(const Arc& arc) {
  if (arc.plane && (arc.angle_rad < 0 || !usable(*arc.plane))) return false;
  return arc.center.allFinite() && arc.center.cwiseAbs().maxCoeff() <= kFarthest && arc.radius_m > 0 &&
         arc.radius_m <= kLargestArc && std::abs(arc.angle_rad) <= kMostTurns;
}

bool usable(const RouteState& state) {
  if (!state.position.allFinite() || state.position.cwiseAbs().maxCoeff() > kFarthest) return false;
  return !state.arc || usable(*state.arc);
}

Leg leg_of(const Site& site, std::size_t index, std::vector<Segment> pieces) {
  Leg leg{.index = index, .pieces = std::move(pieces), .above_ground = {}};
  for (const Segment& piece : leg.pieces) leg.above_ground.include(height_range(site, piece));
  return leg;
}

}  // namespace

Flight::Flight(const Site& asked, const Route& flown) : site(asked), route(flown) {
  if (route.states.size() == 1) {
    const Vec3& only = route.states.front().position;
    legs.push_back(leg_of(site, 0, {{only, only}}));
  }
  for (std::size_t i = 1; i < route.states.size(); ++i) legs.push_back(leg_of(site, i, straight_pieces(route, i)));
}

std::optional<std::size_t> first_unusable_state(const Route& route) {
  for (std::size_t i = 0; i < route.states.size(); ++i) {
    if (!usable(route.states[i])) return i;
  }
  return std::nullopt;
}

}  // namespace alate
