#include "flight_legs.hpp"

#include <algorithm>
#include <cmath>

#include "space/dubins/dubins_point.hpp"

namespace alate::peers {

namespace {

constexpr double kLeastStraight_m = 0.1;  ///< Shorter pieces have no direction, to the rounding of places.
constexpr double kNarrow_m = 0.01;
constexpr double kHeadroom_m = 400;  ///< Above floor, start and goal, where there is no ceiling.

/// The ground, or where there is none the surroundings of both ends.
Box2 area_of(const Site& site) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return raster->area;
  if (const auto* peaks = std::get_if<PeakGround>(&site.ground)) return peaks->area;
  const Vec2 a = site.mission.start.head<2>();
  const Vec2 b = site.mission.goal.head<2>();
  const Vec2 margin = Vec2::Constant((b - a).norm() / 2 + 1000);
  return {a.cwiseMin(b) - margin, a.cwiseMax(b) + margin};
}

bool has_tiny_straight(const Track& track) {
  return std::ranges::any_of(track, [](const PlanarPiece& piece) {
    return piece.steering == Steering::straight && piece.length_m < kLeastStraight_m;
  });
}

}  // namespace

FlightLegs::FlightLegs(const Problem& problem)
    : band_(problem.world),
      flight_cost_(band_),
      objective_(problem.world),
      weights_(problem.objective),
      mission_(problem.mission),
      end_{.goal = problem.mission.goal, .tolerance_m = std::max(0.0, problem.mission.tolerance_m - 1e-3)},
      area_(area_of(problem.world.site())) {}

Track FlightLegs::track(const PlanarPose& from, const PlanarPose& to) const {
  Track track;
  append(track, shortest_dubins(from, to, radius_m()));
  return track;
}

bool FlightLegs::can_fly(const Waypoint& from, const Waypoint& to) const {
  const Track way = track(from.pose, to.pose);
  if (has_tiny_straight(way)) return false;
  AltitudeLabel label = AltitudeLabel::at(from.z);
  for (const PlanarPiece& piece : way)
    if (!band_.advance(piece, label)) return false;
  return label.low <= to.z && to.z <= label.high;
}

double FlightLegs::cost(const Waypoint& from, const Waypoint& to) const {
  const Track way = track(from.pose, to.pose);
  const double length = length_of(way);
  const double climb = to.z - from.z;
  double exposure = 0;
  double at = 0;
  for (const PlanarPiece& piece : way) {
    const double next = at + piece.length_m;
    exposure += flight_cost_.exposure(piece, from.z + climb * at / length, from.z + climb * next / length);
    at = next;
  }
  return weights_.length * std::hypot(length, climb) + weights_.climb * std::max(0.0, climb) +
         weights_.threat * exposure;
}

double FlightLegs::least_cost(const Waypoint& from, const Waypoint& to) const {
  const double climb = to.z - from.z;
  return weights_.length * std::hypot(dubins_length(from.pose, to.pose, radius_m()), climb) +
         weights_.climb * std::max(0.0, climb);
}

double FlightLegs::least_cost_to_goal(const Waypoint& from) const {
  const Vec3 here(from.pose.x, from.pose.y, from.z);
  const double length = (end_.goal - here).norm() - end_.tolerance_m;
  return weights_.length * std::max(0.0, length) + weights_.climb * std::max(0.0, end_.low() - from.z);
}

std::optional<std::pair<double, double>> FlightLegs::altitudes(const PlanarPose& pose) const {
  double floor = 0;
  double ceiling = 0;
  const PlanarPiece here{.steering = Steering::straight, .start = pose, .length_m = kNarrow_m, .radius_m = radius_m()};
  const auto note = [&](const BandPiece& piece) {
    floor = piece.floor_from;
    ceiling = piece.ceiling_from;
    return true;
  };
  if (!area_.contains(pose.position()) || !band_.follow(here, note)) return std::nullopt;
  const double low = std::min(mission_.start.z(), mission_.goal.z()) - kHeadroom_m;
  floor = std::max(floor, low);
  ceiling = std::min(ceiling, std::max({floor, mission_.start.z(), mission_.goal.z()}) + kHeadroom_m);
  return floor <= ceiling ? std::optional(std::pair(floor, ceiling)) : std::nullopt;
}

PlanarPose FlightLegs::pose_on(const PlanarPose& from, const PlanarPose& to, double part) const {
  const DubinsPath path = shortest_dubins(from, to, radius_m());
  return DubinsCursor(path).at(part * path.length_m);
}

bool FlightLegs::can_approach(const Waypoint& to) const {
  constexpr double kRadii = 4;
  const PlanarPose back = reversed(to.pose);
  const PlanarPiece away{
      .steering = Steering::straight, .start = back, .length_m = kRadii * radius_m(), .radius_m = radius_m()};
  BackwardLabel label{.low = to.z, .high = to.z, .ascent = 0, .free = to.z};
  return band_.advance(reversed(away), label);
}

std::optional<PlanarPose> FlightLegs::shot_to_goal(const PlanarPose& from) const {
  Track way;
  append(way, shortest_dubins_to_point(from, end_.place(), radius_m()));
  cut_at_end(way, end_);
  return way.empty() ? std::nullopt : std::optional(way.back().end());
}

double FlightLegs::advance(const PlanarPose& from, const PlanarPose& to, AltitudeLabel& label) const {
  const Track way = track(from, to);
  return has_tiny_straight(way) ? std::numeric_limits<double>::infinity() : flight_cost_.advance(way, label);
}

double FlightLegs::arrive(const AltitudeLabel& label) const {
  const double low = std::max(label.low, end_.low());
  const double high = std::min(label.high, end_.high());
  if (low > high) return std::numeric_limits<double>::infinity();
  return weights_.climb * label.ascent_to(std::clamp(label.free, low, high));
}

Track FlightLegs::track_of(const Way& way) const {
  Track all;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Track leg = track(way[i - 1].pose, way[i].pose);
    all.insert(all.end(), leg.begin(), leg.end());
  }
  return all;
}

std::optional<Route> FlightLegs::route(const Way& way) const {
  const Track all = track_of(way);
  if (all.empty() || has_tiny_straight(all)) return std::nullopt;
  return fly_track(flight_cost_, all, mission_.start, end_);
}

}  // namespace alate::peers
