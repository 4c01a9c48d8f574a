// What the heuristic planners on correction points share: the problem brought to a graph, lower bound, and the way from
// a string of points to a Plan.
#pragma once

#include <functional>
#include <string>

#include "alate/plan/planner.hpp"
#include "space/point_string.hpp"

namespace alate {

/// Why planners that look for the shortest route, every correction working, cannot serve this problem; empty if they
/// can.
std::string heuristic_refusal(const Problem& problem);

/// What a search is given.
struct CorrectionTask {
  const CorrectionGraph& graph;
  RoutePrice price;  ///< As the problem prefers; metres.
};

/// What it found. Nodes are those of the task's graph.
struct CorrectionFound {
  bool found = false;
  PointString points;
  bool exhausted = false;  ///< Proven: there is no route.
  double bound_m = 0;      ///< No route of the whole problem is shorter; 0: nothing known.
  std::uint64_t candidates = 0;
  std::uint64_t expansions = 0;
  std::vector<IterationStats> history;
};

using CorrectionSearch = std::function<CorrectionFound(const CorrectionTask&)>;

/// Builds the graph, cut to the ellipsoid of `corridor` times the relaxed shortest way (0: not cut), runs `search` and
/// wraps up. The cost is that of the problem's objective; the lower bound the longest of the relaxed way and the
/// search's own.
Plan plan_on_corrections(const Problem& problem, RunContext& run, double corridor, const CorrectionSearch& search);

}  // namespace alate
