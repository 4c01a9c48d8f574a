// A route over correction points as a string of nodes, and what the error does along it.
#pragma once

#include <span>
#include <vector>

#include "space/correction_graph.hpp"

namespace alate {

/// Points in order, without start and goal.
using PointString = std::vector<CorrectionGraph::Node>;

/// F = per_m * length + per_correction * corrections.
struct RoutePrice {
  double per_m = 1;
  double per_correction = 0;

  double of(double length_m, std::size_t corrections) const {
    return per_m * length_m + per_correction * static_cast<double>(corrections);
  }
};

/// Start, points and goal in a row. Index i of every array belongs to the i-th of them. After a correction one error is
/// 0 and one number is left (ReducedLeg).
struct Trip {
  std::vector<CorrectionGraph::Node> nodes;
  std::vector<double> leg_m;  ///< Of the leg that ends here; 0 at the start.
  std::vector<double> error;  ///< After the correction here.
  std::vector<double> room;  ///< With more error than this here the rest cannot be flown (to rounding); below 0: never.
  double length_m = 0;
  bool keeps_limits = false;

  std::size_t last() const { return nodes.size() - 1; }
  std::size_t corrections() const { return nodes.size() - 2; }
};

/// Flies the string by the nominal rules, every correction working. Nothing is allocated once `trip` has had the size.
void fly(const CorrectionGraph& graph, std::span<const CorrectionGraph::Node> points, Trip& trip);
Trip fly(const CorrectionGraph& graph, std::span<const CorrectionGraph::Node> points);

/// Are all legs free of obstacles?
bool is_free(const CorrectionGraph& graph, const Trip& trip);

}  // namespace alate
