// One ant's walk, and what a colony keeps of it.
#pragma once

#include <cstdint>
#include <vector>

#include "space/choices.hpp"

namespace alate {

/// Name of a place that can carry a trail.
using TrailKey = std::uint64_t;

struct Ant {
  std::vector<std::uint32_t> actions;
  std::vector<TrailKey> keys;  ///< Where every action led: the nodes u_j of the route.
  double cost = kInfinity;     ///< J_c, eq. (37); infinite unless it arrived.
  std::uint32_t known = 0;     ///< Moves onto a trail that an earlier iteration had left.
  Choices choices;             ///< Scratch, kept so that nothing is allocated while walking.

  bool arrived() const { return cost < kInfinity; }

  void restart() {
    actions.clear();
    keys.clear();
    cost = kInfinity;
    known = 0;
  }
};

/// What a deposit sees of one iteration.
struct Harvest {
  const std::vector<Ant>& ants;
  const Ant& iteration_best;  ///< May not have arrived.
  const Ant& best;            ///< Of all iterations; may not have arrived.
  std::uint64_t iteration = 0;
};

}  // namespace alate
