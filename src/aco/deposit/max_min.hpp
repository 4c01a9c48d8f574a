// MAX-MIN Ant System: only one ant an iteration leaves Q / J, and trails stay within bounds.
//
// Source: Stuetzle, Hoos 2000, sections 2.1-2.4: iteration-best ant, every few iterations the best so far instead;
// tau_max = Q / (rho J_best), tau_min = tau_max / ratio; trails start at tau_max.
#pragma once

#include "aco/ant.hpp"

namespace alate {

struct MaxMin {
  double q = 50;
  double evaporation = 0.2;
  double ratio = 20;
  std::uint64_t best_every = 3;  ///< 0: never the best so far.
  bool started = false;          ///< Has any ant arrived?

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) {
    if (!harvest.best.arrived()) return;
    const double most = q / (evaporation * harvest.best.cost);
    trail.levels().set_bounds(most / ratio, most);
    if (!started) trail.levels().set_unknown(most);
    started = true;
    const bool takes_best = best_every != 0 && harvest.iteration % best_every == 0;
    const Ant& ant = takes_best ? harvest.best : harvest.iteration_best;
    if (!ant.arrived()) return;
    for (const TrailKey node : ant.keys) trail.add(node, q / ant.cost);
  }
};

}  // namespace alate
