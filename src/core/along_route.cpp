#include "alate/core/along_route.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

double length_of(const Route& route, std::size_t i) {
  const Segment leg = route.segment(i);
  const auto& arc = route.states[i].arc;
  if (!arc || arc->plane) return leg.length();
  return std::hypot(arc->radius_m * arc->angle_rad, leg.b.z() - leg.a.z());
}

/// A place on a leg, as its share.
struct Place {
  std::size_t leg = 0;
  double share = 0;
};

std::optional<Place> place_at(const Route& route, double flown_m) {
  if (!(flown_m >= 0) || route.states.size() < 2) return std::nullopt;
  double left = flown_m;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const double length = length_of(route, i);
    if (left < length) return Place{.leg = i, .share = left / length};
    left -= length;
  }
  constexpr double kRounding_m = 1e-6;
  const std::size_t last = route.states.size() - 1;
  return left <= kRounding_m ? std::optional(Place{.leg = last, .share = 1}) : std::nullopt;
}

/// Direction of flight at a place on an arc.
Vec3 direction_on(const Arc& arc, const Vec3& position) {
  const Vec2 spoke = position.head<2>() - arc.center;
  return arc.angle_rad > 0 ? Vec3(spoke.y(), -spoke.x(), 0) : Vec3(-spoke.y(), spoke.x(), 0);
}

Vec3 position_at(const Route& route, const Place& place) {
  const Segment leg = route.segment(place.leg);
  const auto& arc = route.states[place.leg].arc;
  Vec3 position = leg.at(place.share);
  if (!arc || place.share >= 1) return position;
  const double angle = -arc->angle_rad * place.share;
  const Vec2 spoke = leg.a.head<2>() - arc->center;
  position.head<2>() = arc->center + Vec2(spoke.x() * std::cos(angle) - spoke.y() * std::sin(angle),
                                          spoke.x() * std::sin(angle) + spoke.y() * std::cos(angle));
  return position;
}

}  // namespace

double flown_length(const Route& route) {
  double sum = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) sum += length_of(route, i);
  return sum;
}

std::optional<FlightState> state_along(const Route& route, double flown_m) {
  const auto place = place_at(route, flown_m);
  if (!place) return std::nullopt;
  const auto& arc = route.states[place->leg].arc;
  const Segment leg = route.segment(place->leg);
  if ((arc && arc->plane) || (!arc && leg.planar_length() == 0)) return std::nullopt;
  const Vec3 position = position_at(route, *place);
  const Vec3 direction = arc ? direction_on(*arc, position) : Vec3(leg.b - leg.a);
  return FlightState{.position = position, .heading_rad = heading_of(direction), .flown_m = flown_m};
}

Route rest_of(const Route& route, double flown_m) {
  const auto state = state_along(route, flown_m);
  if (!state) return {};
  const Place place = *place_at(route, flown_m);
  Route rest;
  rest.states.push_back({.position = state->position, .leg = LegKind::start});
  for (std::size_t i = place.leg; i < route.states.size(); ++i) rest.states.push_back(route.states[i]);
  if (auto& arc = rest.states[1].arc) arc->angle_rad *= 1 - place.share;
  return rest;
}

Route begin_of(const Route& route, double flown_m) {
  const auto state = state_along(route, flown_m);
  if (!state) return {};
  const Place place = *place_at(route, flown_m);
  Route begin;
  const auto count = static_cast<std::ptrdiff_t>(place.leg) + 1;
  begin.states.assign(route.states.begin(), route.states.begin() + count);
  RouteState& last = begin.states.back();
  last.position = state->position;
  if (last.arc) last.arc->angle_rad *= place.share;
  return begin;
}

}  // namespace alate
