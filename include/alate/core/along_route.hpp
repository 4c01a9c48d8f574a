// Where an aircraft is along a route, and the route from there on.
#pragma once

#include <optional>

#include "alate/core/route.hpp"

namespace alate {

/// An aircraft on its way.
struct FlightState {
  Vec3 position;
  double heading_rad = 0;  ///< Clockwise from +y.
  double flown_m = 0;      ///< Along its route, in space, since the start.
};

/// Metres in space, arcs as they are flown. Turns in tilted planes count as their chords.
double flown_length(const Route& route);

/// After `flown_m` metres; nothing before the start, beyond the end, for what is no number, where the route climbs
/// upright (no heading) and in a turn in a tilted plane.
std::optional<FlightState> state_along(const Route& route, double flown_m);

/// From `flown_m` on; it begins where `state_along` says. Empty where that says nothing.
Route rest_of(const Route& route, double flown_m);

/// Up to `flown_m`. Empty where `state_along` says nothing.
Route begin_of(const Route& route, double flown_m);

}  // namespace alate
