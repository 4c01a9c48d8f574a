// The published heuristic: eta^beta = (1 / J_k)^beta.
//
// Source: Konatowski, Pawlowski 2019, eq. (1). beta is a whole number and is raised by multiplication.
#pragma once

#include "aco/weights.hpp"

namespace alate {

struct PowerHeuristic {
  int beta = 3;

  void operator()(Choices& choices, std::size_t /*ant*/) const { weigh_by_power(beta, choices); }
};

}  // namespace alate
