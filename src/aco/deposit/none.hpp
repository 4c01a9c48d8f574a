// No pheromone: every iteration walks as the first did. The baseline that any trail has to beat.
#pragma once

#include "aco/ant.hpp"

namespace alate {

struct NoDeposit {
  template <class Trail>
  void operator()(Trail& /*trail*/, const Harvest& /*harvest*/) const {}
};

}  // namespace alate
