#include "search/interval/flight_profile.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "space/flight/sheltered_profile.hpp"
#include "space/flight/taut_string.hpp"
#include "space/objective.hpp"

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

Route route_over(const Track& track, const std::vector<ProfilePoint>& profile, const Vec3& start) {
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

/// Places along a track.
class Mileage {
 public:
  explicit Mileage(const Track& track) : track_(track) {
    for (const PlanarPiece& piece : track) ends_.push_back((ends_.empty() ? 0 : ends_.back()) + piece.length_m);
  }
  double length_m() const { return ends_.back(); }
  Vec2 place(double at_m) const {
    const auto end = std::ranges::lower_bound(ends_, std::min(at_m, ends_.back()));
    const PlanarPiece& piece = track_[static_cast<std::size_t>(end - ends_.begin())];
    return piece.at(std::clamp(at_m - (*end - piece.length_m), 0.0, piece.length_m)).position();
  }

 private:
  const Track& track_;
  std::vector<double> ends_;
};

/// Where the track passes threats: the string through the altitudes at which they see least for what it costs.
Route sheltered(const FlightCost& cost, const Track& track, const Vec3& start, const std::vector<Gate>& tube) {
  const Mileage mileage(track);
  const World& world = cost.band().world();
  const auto exposure = [&](double from_m, double to_m, std::span<const double> levels, std::span<double> exposures) {
    const Vec2 a = mileage.place(from_m);
    const Vec2 b = mileage.place(to_m);
    std::ranges::transform(levels, exposures.begin(), [&](double z) {
      return cost.threat_weight() * world.exposure({{a.x(), a.y(), z}, {b.x(), b.y(), z}});
    });
  };
  constexpr double kMostStations = 500;
  const double step_m = std::max(cost.band().radius_m() / 2, mileage.length_m() / kMostStations);
  const auto lane =
      sheltered_lane(tube, step_m, cost.band().slopes(),
                     {.length = cost.length_weight(), .climb = cost.climb_weight(), .exposure = exposure});
  return route_over(track, taut_string(lane, start.z(), std::midpoint(lane.back().floor, lane.back().ceiling)), start);
}

}  // namespace

std::optional<Route> fly_track(const FlightCost& cost, const Track& track, const Vec3& start, const FlightEnd& end) {
  AltitudeLabel label = AltitudeLabel::at(start.z());
  for (const PlanarPiece& piece : track)
    if (!cost.band().advance(piece, label)) return std::nullopt;
  const double low = std::max(label.low, end.low());
  const double high = std::min(label.high, end.high());
  if (low > high) return std::nullopt;
  const std::vector<Gate> gates = gates_of(cost.band(), track);
  Route route = route_over(track, taut_string(gates, start.z(), std::clamp(label.free, low, high)), start);
  if (std::ranges::none_of(track, [&](const PlanarPiece& piece) { return cost.near_threat(piece); })) return route;
  std::vector<Gate> ending = gates;
  ending.back().floor = std::max(ending.back().floor, low);
  ending.back().ceiling = std::min(ending.back().ceiling, high);
  const std::vector<Gate> tube = tube_of(std::move(ending), start.z(), cost.band().slopes());
  if (tube.empty()) return route;
  const Objective objective(cost.band().world());
  Route other = sheltered(cost, track, start, tube);
  return objective.route_cost(other) < objective.route_cost(route) ? other : route;
}

}  // namespace alate
