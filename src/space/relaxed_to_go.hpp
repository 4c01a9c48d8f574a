// How far it is to the goal over correction points, if errors were reset whole at every point.
#pragma once

#include <limits>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/correction_graph.hpp"

namespace alate {

/// Shortest ways to the goal over legs that an aircraft without any error could fly; neither obstacles nor the error
/// that is carried on count. So no route is shorter, and where there is no such way there is no route. Dijkstra's
/// algorithm backward from the goal: legs x log points; A* towards the start where that is all that is asked for.
class RelaxedToGo {
 public:
  enum class Extent { until_start, everywhere };

  RelaxedToGo(const CorrectionGraph& graph, Extent extent, RunContext& run);

  /// Metres; infinity where no way leads to the goal (or, with `until_start`, where it does not matter to the start).
  double operator()(CorrectionGraph::Node node) const { return to_go_[node]; }
  /// `run` ended the search: values are not to be used.
  bool stopped() const { return stopped_; }

 private:
  std::vector<double> to_go_;
  bool stopped_ = false;
};

}  // namespace alate
