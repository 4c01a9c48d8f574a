// Pseudo-random proportional rule: with chance q0 the best choice, else the roulette.
//
// Source: Dorigo, Gambardella 1997 (Ant Colony System), eq. (3).
#pragma once

#include "aco/weights.hpp"
#include "alate/core/stream.hpp"

namespace alate {

struct PseudoRandom {
  double q0 = 0.5;

  std::size_t operator()(const Choices& choices, Stream& stream) const {
    if (stream.uniform() < q0) return heaviest(choices.weight);
    return draw(choices.weight, stream.uniform());
  }
};

}  // namespace alate
