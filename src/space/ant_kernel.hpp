// The inner loops of the attitude lattice for ants: all choices of one state, in single precision.
//
// Plain loops over padded, aligned arrays, compiled thrice (simd.hpp). No contraction and no reassociation, so the bits
// are the same. About 1 ns a choice with three threats.
#pragma once

#include <array>

#include "space/attitude_kernel.hpp"
#include "space/choices.hpp"

namespace alate {

/// B_k in single precision, an array for every entry: [3 * row + column].
using MoveMatrices = std::array<AlignedFloats, 9>;

MoveMatrices move_matrices(const RotationSet& rotations);

/// Position relative to the start of the flight, and attitude by rows.
struct AntPose {
  std::array<float, 3> position;
  std::array<float, 9> attitude;

  AntPose(const Vec3& from_start, const Mat3& f);
};

/// x = p + s F B_k e_x: Konatowski, Pawlowski 2019, eqs. (15)-(25).
void place_choices(const MoveMatrices& moves, const AntPose& pose, float step, Choices& out);

/// The node model relative to the start of the flight, single precision.
struct NodeModel {
  struct Sphere {
    float x, y, z, radius, weight;
    float use_z;  ///< 0: distance to the axis of a cylinder between two heights.
    float floor, top;
  };
  float goal_x, goal_y, goal_z;
  float fuel, step, tolerance;
  std::vector<Sphere> threats;

  NodeModel(const Site& site, const std::vector<NodeThreat>& threats);
};

/// J_k = fuel * distance + threat: eqs. (33), (34); h_k = node_bound (lower_bound.hpp).
void price_choices(const NodeModel& model, Choices& out);

/// place_choices and price_choices of one step in one pass, which leaves out threats that are too far away to count.
void look_one_step(const NodeModel& model, const MoveMatrices& moves, const AntPose& pose, Choices& out);

/// Attitudes after each move: F B_k.
void turn_moves(const MoveMatrices& moves, const AntPose& pose, MoveMatrices& out);

/// A node of the rest of a route, in body axes after the choice.
struct TailNode {
  float x, y, z;
};
/// Cost of the route so far for every choice, and in all once it has arrived (infinite until then).
struct TailSums {
  AlignedFloats sum, total;
};

/// Begins with the choices themselves. Returns as add_tail_node does.
float start_tails(float cost_before, float tolerance, const Choices& ends, TailSums& sums);

/// One node of the tail, and what it is flown behind. Borrows all.
struct TailStep {
  const MoveMatrices& attitudes;
  const TailNode& node;
  const Choices& ends;
};

/// Flies one more node of the tail behind every choice: place (end of k) + F B_k q, in `nodes`. Returns the least sum
/// that those which have not arrived yet can still reach (sum + h).
float add_tail_node(const NodeModel& model, const TailStep& step, Choices& nodes, TailSums& sums);

/// Only places the node, and measures how far it is from the goal.
void measure_tail_node(const NodeModel& model, const TailStep& step, Choices& nodes);

}  // namespace alate
