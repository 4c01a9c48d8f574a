// A way over the ground: arcs of the aircraft's circle and straight pieces, each beginning where the last one ends.
#pragma once

#include <vector>

#include "space/dubins/dubins_path.hpp"

namespace alate {

struct TrackPiece {
  PlanarPose from;
  Steering steering = Steering::straight;
  double length_m = 0;
};

using Track = std::vector<TrackPiece>;

double length_of(const Track& track);

/// The pose `at_m` metres along the piece.
PlanarPose pose_on(const TrackPiece& piece, double at_m, double radius_m);
PlanarPose end_of(const TrackPiece& piece, double radius_m);

/// The same places, flown the other way.
TrackPiece reversed(const TrackPiece& piece, double radius_m);

/// Adds the pieces of a Dubins path that have any length.
void append(Track& track, const DubinsPath& path);

/// The shortest way to a point with any heading there: an arc and a straight piece (Boissonnat, Bui 1994). Nothing if
/// the point lies inside both circles that touch the pose.
bool append_way_to(Track& track, const PlanarPose& from, const Vec2& to, double radius_m);

}  // namespace alate
