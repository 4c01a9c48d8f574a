// The shortest route over correction points with a smallest turn radius: branch and bound on true lengths.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "search/label_setting/remaining.hpp"
#include "space/turning_leg.hpp"

namespace alate {

/// What a search looks for, and what bounds the rest of a route.
struct TurningQuery {
  using Nodes = std::span<const CorrectionGraph::Node>;

  const RemainingLength& length;
  const RemainingCorrections* corrections = nullptr;  ///< Needed where `most_corrections` is given.
  std::optional<int> most_corrections;
  double shorter_than_m = std::numeric_limits<double>::infinity();  ///< Only routes below this length count.
  std::optional<Vec3> heading;  ///< At the start, unit; without it the first leg is straight.
  /// Length of the flight over these nodes, start and goal included, infinite if there is none; never less than on
  /// straight legs, on which the search then goes. Without it legs turn, then are straight.
  std::function<double(Nodes)> flown_m;
};

struct TurningResult {
  std::vector<CorrectionGraph::Node> nodes;  ///< Start and goal included; empty if there is no such route.
  double length_m = std::numeric_limits<double>::infinity();
  /// No route that the query asks for is shorter; the length itself if the tree is exhausted. Infinite if there is
  /// none. With `flown_m`: as that function measures them.
  double bound_m = 0;
  bool exhausted = true;  ///< False after a deadline, a cancel, 10^8 expansions or 10^5 whole routes.
  bool cut = false;       ///< Were ways left out only because they are not below `shorter_than_m`?
  std::uint64_t expansions = 0;
};

/// Legs turn, then are straight (Zhou et al. 2020, problem 2, as the contest has it); errors grow with whole legs. The
/// heading at a point depends on the whole way there, so no label dominates another: depth-first search, the most
/// promising leg first, prunes with the straight rest of the route. Exact in open air: obstacles are not looked at. A
/// point may be used more than once.
TurningResult shortest_turning_route(const CorrectionGraph& graph, const TurningQuery& query, RunContext& run);

}  // namespace alate
