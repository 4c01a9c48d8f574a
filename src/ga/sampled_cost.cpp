#include "ga/sampled_cost.hpp"

namespace alate {

double SampledCost::operator()(const CorrectionGraph& graph, const Trip& trip) const {
  double cost = with_goal ? goal.of(trip.length_m, trip.corrections()) : 0;
  NavigationError error;
  for (std::size_t i = 1; i < trip.nodes.size(); ++i) {
    cost += leg_cost(graph, trip, i, error);
    error = corrected(grown(graph.limits(), error, trip.leg_m[i]), graph.kind(trip.nodes[i]));
  }
  if (range_m) cost += over_range * std::max(0.0, trip.length_m - *range_m);
  return cost;
}

double SampledCost::leg_cost(const CorrectionGraph& graph, const Trip& trip, std::size_t i,
                             const NavigationError& before) const {
  const Navigation& navigation = graph.limits();
  const PointKind kind = graph.kind(trip.nodes[i]);
  Navigation::Limits most = kind == PointKind::vertical ? navigation.at_vertical : navigation.at_horizontal;
  if (kind == PointKind::end) most.vertical = most.horizontal = navigation.theta;
  if (!only_excess) most = {};
  const double from_m = graph.position(trip.nodes[i - 1]).z();
  const double rise_m = graph.position(trip.nodes[i]).z() - from_m;
  double sum = 0;
  for (std::size_t s = 1; s <= samples; ++s) {
    const double share = static_cast<double>(s) / static_cast<double>(samples);
    const NavigationError error = grown(navigation, before, share * trip.leg_m[i]);
    sum += metres_a_unit * (horizontal * std::max(0.0, error.horizontal - most.horizontal) +
                            (1 - horizontal) * std::max(0.0, error.vertical - most.vertical));
    if (ceiling_m) sum += over_altitude * std::max(0.0, from_m + share * rise_m - *ceiling_m);
  }
  return sum / static_cast<double>(samples);
}

}  // namespace alate
