// Local search on the string of actions.
//
// All values at each position, with the rest of the string flown anew; then all pairs of values at two positions near
// to each other, on routes that are as good as the best so far. Repeated until nothing improves. Every change is
// confirmed by flying the whole string exactly.
//
// Source: alate. Cost: a sweep over single positions takes moves^2 / 2 x choices node prices, over pairs
// pair_distance x choices times that. Polls `run` at every position. Determinism: value a writes slot a, the best of
// the lowest indices wins.
#pragma once

#include <span>

#include "aco/ant.hpp"
#include "alate/core/run_context.hpp"
#include "space/attitude_ants.hpp"

namespace alate {

struct ActionString {
  std::size_t pair_distance = 3;
  double pair_margin = 0;  ///< Pairs are tried where cost <= best * (1 + margin).

  /// Improves the ant's actions and cost; was the route changed?
  bool operator()(const AttitudeAnts& space, Ant& ant, double best_cost, RunContext& run) const;
};

}  // namespace alate
