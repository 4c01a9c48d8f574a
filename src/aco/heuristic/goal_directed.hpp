// A heuristic that looks past the next node: eta = exp(-((J + h)_k - min(J + h)) / scale).
//
// Departure from Konatowski, Pawlowski 2019, whose (1 / J_k)^beta hardly tells choices apart far from the goal. h is
// the guide of the space. A small scale is a greedy walk, a large one a random walk; which serves best depends on the
// scenario, so the ants of a colony have scales from the greatest to the least, in equal ratios.
#pragma once

#include <cmath>

#include "aco/weights.hpp"

namespace alate {

class GoalDirected {
 public:
  /// Ant 0 has `greatest`, the last one `greatest` / `spread`.
  GoalDirected(double greatest, double spread, std::size_t ants) {
    for (std::size_t a = 0; a < ants; ++a) {
      const double share = ants > 1 ? static_cast<double>(a) / static_cast<double>(ants - 1) : 0;
      scales_.push_back(static_cast<float>(greatest * std::pow(spread, -share)));
    }
  }

  void operator()(Choices& choices, std::size_t ant) const { weigh_by_goal(scales_[ant], choices); }

 private:
  std::vector<float> scales_;
};

}  // namespace alate
