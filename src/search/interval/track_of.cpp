#include "search/interval/track_of.hpp"

#include <cmath>

namespace alate {

namespace {

constexpr double kLeast_m = 1e-6;
constexpr double kTouch_rad = 1e-6;  ///< As the check grants between arcs and their neighbours.

/// Leg `i` as a piece of its own radius; of no length where it is upright.
PlanarPiece piece_of(const Route& route, std::size_t i) {
  const Segment leg = route.segment(i);
  const auto& arc = route.states[i].arc;
  if (!arc || arc->plane) {
    const Vec3 way = leg.b - leg.a;
    return {.steering = Steering::straight,
            .start = planar_pose(leg.a.x(), leg.a.y(), std::atan2(way.y(), way.x())),
            .length_m = leg.planar_length(),
            .radius_m = 1};
  }
  const Vec2 spoke = leg.a.head<2>() - arc->center;
  const bool right = arc->angle_rad > 0;
  const double heading = std::atan2(spoke.y(), spoke.x()) + (right ? -kPi / 2 : kPi / 2);
  return {.steering = right ? Steering::right : Steering::left,
          .start = planar_pose(leg.a.x(), leg.a.y(), heading),
          .length_m = arc->radius_m * std::abs(arc->angle_rad),
          .radius_m = arc->radius_m};
}

bool touches(const PlanarPose& end, const PlanarPose& start) {
  return std::abs(wrapped(end.heading - start.heading)) < kTouch_rad;
}

}  // namespace

Track track_of(const Route& route, double radius_m) {
  Track track;
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    PlanarPiece piece = piece_of(route, i);
    if (piece.length_m < kLeast_m) continue;
    const bool flown_so =
        piece.steering == Steering::straight || std::abs(piece.radius_m - radius_m) < kLeast_m * radius_m;
    const bool joins = track.empty() || touches(track.back().end(), piece.start);
    if (!flown_so || !joins) {
      append(track, shortest_dubins(track.empty() ? piece.start : track.back().end(), piece.end(), radius_m));
    } else if (!track.empty() && track.back().steering == piece.steering) {
      track.back().length_m += piece.length_m;
    } else {
      piece.radius_m = radius_m;
      track.push_back(piece);
    }
  }
  return track;
}

}  // namespace alate
