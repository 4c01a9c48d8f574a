// A Dubins path as arcs and segments, and the poses along it.
#pragma once

#include "space/dubins/dubins_path.hpp"

namespace alate {

/// Part of a circle; angles of points seen from the centre, counter-clockwise from +x.
struct PlanarArc {
  Vec2 center;
  double radius_m = 0;
  double start_rad = 0;
  double sweep_rad = 0;  ///< Negative for a turn to the right.

  Vec2 at(double angle_rad) const;
};

/// A piece of way on one circle, or straight.
struct PlanarPiece {
  Steering steering = Steering::straight;
  PlanarPose start;
  double length_m = 0;
  double radius_m = 0;

  /// Pose after `s_m` metres.
  PlanarPose at(double s_m) const { return moved(start, planar_motion(steering, s_m, radius_m)); }
  PlanarPose end() const { return at(length_m); }
  /// Of a turn only.
  PlanarArc arc() const;
  /// False only where all of it is at least so far from a place; exact for a straight piece.
  bool may_come_within(double reach_m, const Vec2& place) const;
};

/// The three pieces, those without length too.
std::array<PlanarPiece, 3> pieces_of(const DubinsPath& path);

/// Poses at any place of a path.
class DubinsCursor {
 public:
  explicit DubinsCursor(const DubinsPath& path) : pieces_(pieces_of(path)) {}

  const std::array<PlanarPiece, 3>& pieces() const { return pieces_; }

  /// Pose after `s_m` metres; before the start and beyond the end it goes on as the first and the last piece do.
  PlanarPose at(double s_m) const;

 private:
  std::array<PlanarPiece, 3> pieces_;
};

}  // namespace alate
