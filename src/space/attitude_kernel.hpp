// The inner loops of the attitude lattice over all candidates of one expansion.
//
// Plain loops over aligned arrays, compiled thrice (simd.hpp). No contraction and no reassociation, so the bits are the
// same.
#pragma once

#include <vector>

#include "space/rotations.hpp"

namespace alate {

/// Where the aircraft is before the move.
struct BodyPose {
  Vec3 position;
  Mat3 attitude;
};

/// Fills directions F B_k e_x and ends p + s F B_k e_x.
void place_candidates(const RotationSet& rotations, const BodyPose& pose, double step_m, Candidates& out);

/// Fills the distances of the ends to the goal.
void measure_to_goal(const Vec3& goal, Candidates& out);

/// What a leg may do, written so that the test needs no trigonometry.
struct LegLimits {
  double max_sine = 1;       ///< Sine of the steepest climb.
  double min_sine = -1;      ///< Sine of the steepest descent, negative.
  double turn_radius_m = 0;  ///< 0: not limited.
};

/// Sets the cost of every candidate: `leg_cost` plus `climb_cost` per metre of ascent, or infinity where a limit is
/// broken. The turn rule is that of the check: min(L_before, L_after) / 2 / tan(theta / 2) >= turn radius, with
/// planar lengths and theta the change of heading. `before` is the leg flown before; only its direction counts where
/// `before_is_heading`.
struct BaseCosts {
  LegLimits limits;
  double step_m = 0;
  double leg_cost = 0;
  double climb_cost = 0;
  Vec3 before;  ///< Metres.
  bool before_is_heading = false;
};
void set_base_costs(const BaseCosts& base, Candidates& out);

/// The same tests for one leg.
bool within_limits(const BaseCosts& base, const Vec3& leg);

/// Threat of the node model: weight * max(0, radius - d), d to the centre, or to the axis between two heights.
struct NodeThreat {
  Vec3 center;
  double radius_m = 0;
  double weight = 0;
  double use_z = 1;  ///< 0: distance to the axis.
  double floor_m = -kInfinity;
  double top_m = kInfinity;
};

/// Adds fuel * distance to the goal and every threat: Konatowski, Pawlowski 2019, eqs. (33), (34).
void add_node_costs(double fuel, const std::vector<NodeThreat>& threats, Candidates& out);

}  // namespace alate
