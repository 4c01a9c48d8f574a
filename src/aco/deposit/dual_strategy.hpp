// The dynamically adjusted pheromone update of Mai et al. 2023: only the best path of an iteration is updated.
//
// Source: eqs. (16)-(19), verbatim. lambda shrinks as printed, so the weight of the global best falls late in the run,
// where the prose wants refinement. Open in the paper, and options here: whether (1 - rho) of (16) acts on that path
// only, as written, or everywhere; and whose fitness fit_current is. On the path the trail tends to Delta / rho.
#pragma once

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"

namespace alate {

struct DualStrategy {
  double q = 100;
  double evaporation = 0.2;   ///< rho.
  double least = 0.1;         ///< tau_min.
  double most = 10;           ///< tau_max.
  double lambda = 0.5;        ///< Weight of the global best, 0 to 1.
  double gamma = 0.9;         ///< lambda is multiplied by it ...
  std::uint64_t every = 100;  ///< ... after so many iterations, never before the first.
  bool on_path = true;        ///< Evaporation acts on the updated path only; else the colony has seen to it.
  bool each_ant = false;      ///< Every ant that arrived updates its path with its own fitness.

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) {
    trail.levels().set_bounds(least, most);  // eq. (18)
    if (each_ant) {
      for (const Ant& ant : harvest.ants)
        if (ant.arrived()) update(trail, ant, harvest.best);
    } else if (harvest.iteration_best.arrived()) {
      update(trail, harvest.iteration_best, harvest.best);
    }
    if (harvest.iteration % every == 0) lambda *= gamma;  // eq. (19)
  }

 private:
  template <class Trail>
  void update(Trail& trail, const Ant& ant, const Ant& best) const {
    const double global = best.arrived() ? best.cost : ant.cost;
    const double amount = q / ((1 - lambda) * ant.cost + lambda * global);  // eq. (17)
    for (const TrailKey key : ant.keys) {
      if (on_path)
        trail.blend(key, evaporation, amount / evaporation);  // eq. (16)
      else
        trail.add(key, amount);
    }
  }
};

}  // namespace alate
