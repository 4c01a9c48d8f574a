// A heuristic that looks past the next node: eta = exp(-((J + h)_k - min(J + h)) / scale).
//
// Departure from Konatowski, Pawlowski 2019, whose (1 / J_k)^beta hardly tells choices apart far from the goal. h is
// the guide of the space. A small scale is a greedy walk, a large one a random walk.
#pragma once

#include "aco/weights.hpp"

namespace alate {

struct GoalDirected {
  float scale = 1;

  void operator()(Choices& choices) const { weigh_by_goal(scale, choices); }
};

}  // namespace alate
