// Rates of crossover and mutation that fall as fitness rises.
//
// Source: Zhou et al. 2020, section on the improved genetic algorithm, after Srinivas, Patnaik 1994:
//   P = P1 - (P1 - P2) (f - f_avg) / (f_max - f_avg)  if f >= f_avg, else P1.
// For crossover f is the fitness of the better parent, for mutation that of the mutant. The text raises the best
// individual to P1; the formula leaves it at P2, and the formula is followed. Departure: where all are equally fit the
// formula is 0/0; read as P1, as such a population needs change.
#pragma once

namespace alate {

/// Fitness over a population.
struct FitnessStats {
  double mean = 0;
  double most = 0;
};

struct AdaptiveRate {
  double high = 0;  ///< P1.
  double low = 0;   ///< P2; equal to `high`: constant.

  double operator()(double fitness, const FitnessStats& stats) const {
    if (fitness < stats.mean || !(stats.most > stats.mean)) return high;
    return high - (high - low) * (fitness - stats.mean) / (stats.most - stats.mean);
  }
};

}  // namespace alate
