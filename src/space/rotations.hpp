// The moves of the attitude lattice: constant rotations of the body.
#pragma once

#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"
#include "space/candidates.hpp"

namespace alate {

/// Every combination of the vehicle's roll, pitch and yaw angles, as constant body-frame matrices, in the order of the
/// scenario: yaw runs fastest, roll slowest.
///
/// Source: Konatowski, Pawlowski 2019, eqs. (15)-(25). Three rotations about successively rotated body axes are one
/// product from the right: F' = F B_k, B_k = Rx(roll) Ry(-pitch) Rz(-yaw).
/// Departure: the paper leaves the signs of pitch and yaw open and prints no minus. Ours follow the scenario (nose
/// up and nose right are positive) with body axes forward, left, up. The paper's angle sets are symmetric, so the
/// reachable set is the same.
/// With pitch = yaw = 0 every roll gives the same direction (but another attitude): the paper's 125 actions have
/// 121 distinct directions. They stay separate actions.
class RotationSet {
 public:
  explicit RotationSet(const Vehicle& vehicle);

  std::size_t size() const { return actions_.size(); }
  const AttitudeAction& action(std::size_t k) const { return actions_[k]; }
  const Mat3& matrix(std::size_t k) const { return matrices_[k]; }

  /// Components of B_k e_x, the new direction seen from the body.
  const AlignedDoubles& forward_x() const { return forward_x_; }
  const AlignedDoubles& forward_y() const { return forward_y_; }
  const AlignedDoubles& forward_z() const { return forward_z_; }

  /// Largest angle between the directions of two legs in a row, radians.
  double largest_turn() const { return largest_turn_; }

 private:
  void add(const AttitudeAction& action);

  std::vector<AttitudeAction> actions_;
  std::vector<Mat3> matrices_;
  AlignedDoubles forward_x_, forward_y_, forward_z_;
  double largest_turn_ = 0;
};

/// B of one action.
Mat3 body_rotation(const AttitudeAction& action);

/// Level flight at this heading: columns are the body axes forward, left, up. Identity for heading 90 degrees.
Mat3 level_attitude(double heading_rad);

}  // namespace alate
