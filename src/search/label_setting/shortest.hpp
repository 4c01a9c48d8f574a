// The shortest route over correction points, by A* on labels (length, error).
#pragma once

#include <limits>
#include <optional>

#include "alate/core/run_context.hpp"
#include "search/label_setting/label.hpp"

namespace alate {

struct ShortestOptions {
  double weight = 1;        ///< Of the straight line to the goal in the order; 1: the first arrival is the shortest.
  double correction_m = 0;  ///< What a correction costs beside the length.
  double most_m = std::numeric_limits<double>::infinity();  ///< Longer routes are not looked for.
};

struct ShortestResult {
  std::optional<CorrectionRoute> route;
  double bound_m = 0;        ///< With weight 1 and free corrections: no route is shorter. Infinite: there is none.
  std::uint64_t labels = 0;  ///< Expanded.
  bool stopped = false;      ///< By `run`, before an answer was known.
};

/// A* (Hart, Nilsson, Raphael 1968) with one label for each way to a node that no earlier one is as good as. As the
/// straight line is consistent, labels leave the queue at each node in the order of their lengths; one number a node,
/// the least error so far, then decides dominance. With a weight above 1 the route may be longer than need be, but
/// still one is found if there is any: a label passed over has no less error than one that was expanded.
ShortestResult shortest_route(const CorrectionGraph& graph, const ShortestOptions& options, RunContext& run);

}  // namespace alate
