#include "space/flight/track.hpp"

#include <cmath>

namespace alate {

namespace {

/// Pieces below this are rounding; metres.
constexpr double kNoLength = 1e-9;

struct ArcThenStraight {
  Steering steering = Steering::left;
  double arc_m = 0;
  double straight_m = std::numeric_limits<double>::infinity();

  double length() const { return arc_m + straight_m; }
};

/// Turning to one side until the tangent passes through the point.
ArcThenStraight turn_towards(const PlanarPose& from, const Vec2& to, double radius_m, Steering steering) {
  const double side = static_cast<double>(steering);
  const Vec2 center = from.position() + side * radius_m * Vec2(-from.sin, from.cos);
  const Vec2 off = to - center;
  const double squared = off.squaredNorm() - radius_m * radius_m;
  if (squared < 0) return {};
  const double straight = std::sqrt(squared);
  // off = straight * direction + radius to the outer side of it.
  const Vec2 direction(off.x() * straight - side * off.y() * radius_m, off.y() * straight + side * off.x() * radius_m);
  const double ahead = direction.dot(from.direction());
  const double aside = side * (from.cos * direction.y() - from.sin * direction.x());
  double turn = std::atan2(aside, ahead);
  if (turn < -1e-12) turn += 2 * kPi;
  return {steering, std::max(0.0, turn) * radius_m, straight};
}

}  // namespace

double length_of(const Track& track) {
  double sum = 0;
  for (const TrackPiece& piece : track) sum += piece.length_m;
  return sum;
}

PlanarPose pose_on(const TrackPiece& piece, double at_m, double radius_m) {
  return moved(piece.from, planar_motion(piece.steering, at_m, radius_m));
}

PlanarPose end_of(const TrackPiece& piece, double radius_m) { return pose_on(piece, piece.length_m, radius_m); }

TrackPiece reversed(const TrackPiece& piece, double radius_m) {
  return {reversed(end_of(piece, radius_m)), static_cast<Steering>(-static_cast<int>(piece.steering)), piece.length_m};
}

void append(Track& track, const DubinsPath& path) {
  const auto steering = steering_of(path.word);
  PlanarPose at = path.start;
  for (std::size_t i = 0; i < steering.size(); ++i) {
    if (path.lengths_m[i] <= kNoLength) continue;
    track.push_back({at, steering[i], path.lengths_m[i]});
    at = end_of(track.back(), path.radius_m);
  }
}

bool append_way_to(Track& track, const PlanarPose& from, const Vec2& to, double radius_m) {
  const ArcThenStraight left = turn_towards(from, to, radius_m, Steering::left);
  const ArcThenStraight right = turn_towards(from, to, radius_m, Steering::right);
  const ArcThenStraight& best = right.length() < left.length() ? right : left;
  if (!std::isfinite(best.length())) return false;
  PlanarPose at = from;
  if (best.arc_m > kNoLength) {
    track.push_back({at, best.steering, best.arc_m});
    at = end_of(track.back(), radius_m);
  }
  if (best.straight_m > kNoLength) track.push_back({at, Steering::straight, best.straight_m});
  return true;
}

}  // namespace alate
