// What is flown: ordered states in one frame with the kind of leg that leads to each. No cost, no history.
#pragma once

#include <optional>
#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

enum class LegKind { start, straight, arc, climb };

const char* to_string(LegKind kind);

/// The plane of a turn that is neither level nor a helix.
struct ArcPlane {
  double center_z_m = 0;
  Vec3 normal;  ///< Unit; seen against it the turn is counter-clockwise.
};

/// A turn at constant radius: level, or climbing evenly about an upright axis; with `plane`, a circle in a tilted
/// plane.
struct Arc {
  Vec2 center;
  double radius_m = 0;
  double angle_rad = 0;  ///< Signed, clockwise (to the right) positive; with `plane` the whole angle, positive.
  std::optional<ArcPlane> plane;  ///< The height changes along such a circle as the circle does.
};

/// One move on the attitude lattice, rotations about the body axes in the order of use.
struct AttitudeAction {
  double roll_rad = 0;   ///< Right wing down positive.
  double pitch_rad = 0;  ///< Nose up positive.
  double yaw_rad = 0;    ///< Nose right positive.
};

struct RouteState {
  Vec3 position;  ///< Frame metres; z above mean sea level.
  LegKind leg = LegKind::straight;
  std::optional<Arc> arc;                ///< Present exactly for LegKind::arc.
  std::optional<AttitudeAction> action;  ///< The move that led here, for attitude routes.
  std::optional<int> point_id;           ///< Correction point at this state.
};

/// First state has LegKind::start; leg i ends at state i. Empty: no route.
struct Route {
  std::vector<RouteState> states;

  bool empty() const { return states.empty(); }
  /// Straight line of leg `i`, 1 <= i < states.size().
  Segment segment(std::size_t i) const { return {states[i - 1].position, states[i].position}; }
};

}  // namespace alate
