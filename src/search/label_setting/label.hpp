// A route over correction points as the searches hand it on, free of the graph that it was found in.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "space/candidates.hpp"
#include "space/correction_graph.hpp"

namespace alate {

struct CorrectionRoute {
  double length_m = 0;
  std::vector<CorrectionPoint> points;  ///< In order, without start and goal.
};

/// Sums of some thousand lengths differ by less, relatively, in whatever order.
inline constexpr double kRounding = 1e-12;
/// Labels expanded between two looks at the clock.
inline constexpr std::uint64_t kPollEvery = 1024;
inline constexpr std::uint32_t kNoLabel = ~std::uint32_t{0};

/// One way to a node. Labels live in one growing pool and know their parents by index.
struct Label {
  double length_m = 0;
  double error = 0;
  CorrectionGraph::Node node = 0;
  std::uint32_t parent = kNoLabel;
  int corrections = 0;
};

/// The points on the way to label `last` of `pool`, its own included, start and goal left out.
inline std::vector<CorrectionPoint> points_to(const CorrectionGraph& graph, std::span<const Label> pool,
                                              std::uint32_t last) {
  std::vector<CorrectionPoint> points;
  for (std::uint32_t at = last; at != kNoLabel; at = pool[at].parent)
    if (pool[at].node < graph.point_count()) points.push_back(graph.point(pool[at].node));
  std::ranges::reverse(points);
  return points;
}

}  // namespace alate
