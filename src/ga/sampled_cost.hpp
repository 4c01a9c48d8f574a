// The cost that the genetic algorithm of Zhou et al. 2020 selects by.
#pragma once

#include <optional>

#include "space/point_string.hpp"

namespace alate {

/// f = f1 + f2, with f1 = w1 g_h + w2 g_v and f2 = w1' p1 + w2' p2, every leg sampled at some points, and the goal F.
/// Gaps of the paper, each a field: what g and p are exactly, and whether F is part of f (its printed objective adds
/// errors to metres, so it is here).
struct SampledCost {
  std::size_t samples = 10;  ///< On each leg, its end among them.
  double horizontal = 0.5;   ///< w1; w2 is 1 - w1.
  double metres_a_unit = 1;  ///< What a unit of error counts beside F.
  bool only_excess = true;   ///< g: mean over samples of what exceeds the limit at the leg's end; else of the error.
  double over_altitude = 1;  ///< w1', by p1: mean of the metres above `ceiling_m`.
  double over_range = 1;     ///< w2', by p2: metres flown beyond `range_m`.
  bool with_goal = true;     ///< F is added.
  RoutePrice goal;           ///< F.
  std::optional<double> ceiling_m;
  std::optional<double> range_m;

  /// Of any string, feasible or not. Corrections work even where a limit was broken, so that later legs count alone.
  double operator()(const CorrectionGraph& graph, const Trip& trip) const;

 private:
  double leg_cost(const CorrectionGraph& graph, const Trip& trip, std::size_t i, const NavigationError& before) const;
};

}  // namespace alate
