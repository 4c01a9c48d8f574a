// The exact Pareto front of length and number of corrections.
#pragma once

#include <optional>

#include "alate/core/run_context.hpp"
#include "search/label_setting/label.hpp"

namespace alate {

struct FrontResult {
  std::vector<CorrectionRoute> routes;  ///< More corrections and shorter, one after the other.
  std::optional<CorrectionRoute> best;  ///< Shortest known, if the search was stopped.
  double bound_m = 0;                   ///< No route is shorter. Infinity: there is none.
  std::uint64_t labels = 0;
  bool stopped = false;
  bool proven = true;  ///< False: the routes are good, but others may be better.
};

/// First a good route by weighted A* and one with few corrections; then the fewest corrections, proven by a backward
/// sweep; then the shortest route with that few, whose length is the corridor in which all others of the front lie.
/// There the bounds on what is left are made, and a layered search fills in the front. It is tried with caps on the
/// lengths that are guessed; what comes out below its cap is proven, and only the rest is looked for again.
FrontResult correction_front(const CorrectionGraph& graph, RunContext& run);

/// The shortest route alone, proven: a good one by weighted A*, whose length is the corridor of the search that proves.
FrontResult shortest_alone(const CorrectionGraph& graph, RunContext& run);

}  // namespace alate
