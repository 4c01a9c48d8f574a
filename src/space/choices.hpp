// What an ant sees from one state: a structure of arrays in single precision, filled again at every step.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "space/candidates.hpp"

namespace alate {

/// Index k belongs to action k. Arrays are padded with choices of infinite cost. Places are relative to the start of
/// the flight, so that single precision holds: 4e-6 at 40 units, 2 mm at 30 km.
struct Choices {
  AlignedFloats x, y, z;  ///< Where the leg ends.
  AlignedFloats to_goal;  ///< Straight distance left from there.
  AlignedFloats cost;     ///< J_k; infinite: not in K by what costs little to test.
  AlignedFloats guide;    ///< h_k, estimated cost from there to the goal.
  AlignedFloats trail;    ///< tau_k; what a store keeps for it until the levels are read.
  AlignedFloats weight;   ///< Chance of being chosen, not normalised.
  Candidates wide;        ///< For models that are priced in double precision first.

  /// Nothing is allocated once the size has been reached.
  void resize(std::size_t count) {
    for (AlignedFloats* array : {&x, &y, &z, &to_goal, &cost, &guide, &trail, &weight})
      array->resize(padded_size(count));
  }
};

/// What a string of actions costs until its first arrival, and how many of them that takes.
struct FlownActions {
  double cost = 0;
  std::size_t moves = 0;
  std::vector<float> costs;  ///< Of each move.
};

/// Box relative to the start, metres.
struct ReachBox {
  Eigen::Vector3f min;
  Eigen::Vector3f max;
};

}  // namespace alate
