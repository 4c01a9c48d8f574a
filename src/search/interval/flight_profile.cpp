#include "search/interval/flight_profile.hpp"

#include <algorithm>

#include "space/flight/taut_string.hpp"

namespace alate {

namespace {

/// Both ends of every stretch over which floor and ceiling are straight.
std::vector<Gate> gates_of(const BandWalk& band, const Track& track) {
  std::vector<Gate> gates;
  double at = 0;
  const auto add = [&](double floor, double ceiling) {
    if (!gates.empty() && gates.back().at_m == at) {
      gates.back().floor = std::max(gates.back().floor, floor);
      gates.back().ceiling = std::min(gates.back().ceiling, ceiling);
    } else {
      gates.push_back({at, floor, ceiling});
    }
  };
  for (const PlanarPiece& piece : track)
    band.follow(piece, [&](const BandPiece& part) {
      add(part.floor_from, part.ceiling_from);
      at += part.length_m;
      add(part.floor_to, part.ceiling_to);
      return true;
    });
  return gates;
}

RouteState state_on(const PlanarPiece& piece, double at_m, double z, double flown_m) {
  const PlanarPose pose = piece.at(at_m);
  RouteState state{.position = {pose.x, pose.y, z}, .leg = LegKind::straight};
  if (piece.steering == Steering::straight) return state;
  const PlanarArc arc = piece.arc();
  const auto side = static_cast<double>(piece.steering);
  state.leg = LegKind::arc;
  state.arc =
      Arc{.center = arc.center, .radius_m = arc.radius_m, .angle_rad = -side * flown_m / arc.radius_m, .plane = {}};
  return state;
}

}  // namespace

std::optional<Route> fly_track(const BandWalk& band, const Track& track, const Vec3& start, const FlightEnd& end) {
  AltitudeLabel label = AltitudeLabel::at(start.z());
  for (const PlanarPiece& piece : track)
    if (!band.advance(piece, label)) return std::nullopt;
  const double low = std::max(label.low, end.low());
  const double high = std::min(label.high, end.high());
  if (low > high) return std::nullopt;
  const auto profile = taut_string(gates_of(band, track), start.z(), std::clamp(label.free, low, high));

  Route route;
  route.states.push_back({.position = start, .leg = LegKind::start});
  double begin = 0;
  for (const PlanarPiece& piece : track) {
    double from = 0;
    for (const ProfilePoint& bend : profile) {
      const double at = bend.at_m - begin;
      constexpr double kLeast_m = 0.01;  // what is left out here is within BandWalk's spare height
      if (at < kLeast_m || at > piece.length_m - kLeast_m || at < from + kLeast_m) continue;
      route.states.push_back(state_on(piece, at, bend.z, at - from));
      from = at;
    }
    route.states.push_back(
        state_on(piece, piece.length_m, altitude_at(profile, begin + piece.length_m), piece.length_m - from));
    begin += piece.length_m;
  }
  return route;
}

}  // namespace alate
