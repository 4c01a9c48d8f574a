// Ant System: every ant that arrived leaves Q / J_c on each node of its route.
//
// Source: Konatowski, Pawlowski 2019, eqs. (3), (4), (36), with J_c of eq. (37). Departure: eq. (4) has no index of the
// node and eq. (36) an argument "(rho)"; read as: on the nodes of ant i's route, nothing elsewhere. Ants that did not
// arrive leave nothing, as their cost cannot be compared.
#pragma once

#include "aco/ant.hpp"

namespace alate {

struct AntSystem {
  double q = 50;

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) const {
    for (const Ant& ant : harvest.ants) {
      if (!ant.arrived()) continue;
      for (const TrailKey node : ant.keys) trail.add(node, q / ant.cost);  // eq. (4)
    }
  }
};

}  // namespace alate
