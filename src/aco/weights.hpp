// Weights of choices in single precision: products of trail and heuristic, their sums, and one draw.
//
// Loops over padded, aligned arrays, compiled thrice (space/simd.hpp) with the same bits.
#pragma once

#include "aco/pheromone/levels.hpp"
#include "space/choices.hpp"

namespace alate {

/// weight = (min J / J)^beta, in proportion to (1 / J)^beta; 0 where J is infinite.
void weigh_by_power(int beta, Choices& choices);

/// weight = exp(-((J + h) - min(J + h)) / scale); 0 where J + h is infinite.
void weigh_by_goal(float scale, Choices& choices);

/// trail = tau, read from what is stored for it; weight *= tau^alpha.
void multiply_by_trail(const TrailLevels& levels, int alpha, Choices& choices);

/// Index drawn in proportion to the weights by `uniform` in [0, 1); size() of the array where all weights are 0.
std::size_t draw(const AlignedFloats& weights, double uniform);

/// Index of the greatest weight, the first of equals; size() of the array where all weights are 0.
std::size_t heaviest(const AlignedFloats& weights);

}  // namespace alate
