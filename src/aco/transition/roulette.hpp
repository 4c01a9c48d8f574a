// Random proportional rule: choice k with probability weight_k / sum.
//
// Source: Konatowski, Pawlowski 2019, eq. (1); Dorigo, Maniezzo, Colorni 1996.
#pragma once

#include "aco/weights.hpp"
#include "alate/core/stream.hpp"

namespace alate {

struct Roulette {
  std::size_t operator()(const Choices& choices, Stream& stream) const {
    return draw(choices.weight, stream.uniform());
  }
};

}  // namespace alate
