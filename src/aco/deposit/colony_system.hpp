// Ant Colony System: every move wears its trail down towards tau_0, and the best so far draws its own up.
//
// Source: Dorigo, Gambardella 1997, eqs. (4), (5): local tau <- (1 - xi) tau + xi tau_0 on every node visited, global
// tau <- (1 - rho) tau + rho Q / J_best on the best route. Nothing else evaporates. Departures: local updates come
// after the iteration, ant by ant, so that ants may walk at the same time; tau_0 is a tenth of the first best deposit.
#pragma once

#include "aco/ant.hpp"

namespace alate {

struct ColonySystem {
  double q = 50;
  double evaporation = 0.1;
  double wear = 0.1;  ///< xi.
  double first = 0;   ///< tau_0; set by the first arrival.

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) {
    if (!harvest.best.arrived()) return;
    if (first == 0) trail.levels().set_unknown(first = kFirstShare * q / harvest.best.cost);
    for (const Ant& ant : harvest.ants)
      for (const TrailKey node : ant.keys) trail.blend(node, wear, first);
    for (const TrailKey node : harvest.best.keys) trail.blend(node, evaporation, q / harvest.best.cost);
  }

  static constexpr double kFirstShare = 0.1;
};

}  // namespace alate
