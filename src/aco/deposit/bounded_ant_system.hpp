// All ants deposit, evaporation slows down, and trails have bounds: Li et al. 2019 and Yin et al. 2021.
//
// Source: Yin et al. 2021, eqs. (7)-(11); forms [C] from the public program for Li et al. 2019, order and numbers [R].
// What the colony calls before this, `evaporate`, is the first term of eq. (9).
#pragma once

#include <algorithm>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"

namespace alate {

struct BoundedAntSystem {
  /// How eq. (11) acts. As meant: on each trail. As coded: if all trails are below tau_min, or all above tau_max, all
  /// become tau_min or tau_max, tested before evaporation; it hardly ever acts.
  enum class Bounds { each_trail, whole_matrix };
  /// What Q is divided by in eq. (7): the score S [C], or the length as the prose of the paper may mean.
  enum class Over { score, length };

  double q = 100;
  double evaporation = 0.3;  ///< rho of the first iteration.
  double decay = 0.95;       ///< Eq. (10).
  double least_evaporation = 0.2;
  double least = 10;  ///< tau_min.
  double most = 40;   ///< tau_max.
  Bounds bounds = Bounds::each_trail;
  Over over = Over::score;

  template <class Trail>
  void operator()(Trail& trail, const Harvest& harvest) {
    if (bounds == Bounds::whole_matrix)
      bound_matrix(trail);
    else
      trail.levels().set_bounds(least, most);  // eq. (11)
    for (const Ant& ant : harvest.ants) {
      if (!ant.arrived()) continue;
      const double amount = q / (over == Over::score ? ant.cost : ant.sum);  // eq. (7)
      for (const TrailKey move : ant.keys) trail.add(move, amount);          // eq. (8), (9)
    }
    evaporation = std::max(decay * evaporation, least_evaporation);  // eq. (10)
    trail.levels().set_evaporation(evaporation);
  }

 private:
  /// Trails have just evaporated: before that they were 1 / (1 - rho) times as high.
  template <class Trail>
  void bound_matrix(Trail& trail) const {
    const double kept = 1 - evaporation;
    const auto [low, high] = trail.extremes();
    if (high < least * kept) trail.reset(least * kept);
    if (low > most * kept) trail.reset(most * kept);
  }
};

}  // namespace alate
