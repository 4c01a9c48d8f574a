#include "space/point_string.hpp"

#include <limits>

namespace alate {

namespace {

void measure_legs(const CorrectionGraph& graph, Trip& trip) {
  trip.leg_m.assign(trip.nodes.size(), 0);
  trip.length_m = 0;
  for (std::size_t i = 1; i < trip.nodes.size(); ++i) {
    trip.leg_m[i] = graph.length(trip.nodes[i - 1], trip.nodes[i]);
    trip.length_m += trip.leg_m[i];
  }
}

void carry_errors(const CorrectionGraph& graph, Trip& trip) {
  trip.error.assign(trip.nodes.size(), 0);
  trip.keeps_limits = true;
  for (std::size_t i = 1; i < trip.nodes.size(); ++i) {
    const ReducedLeg& leg = graph.leg(trip.nodes[i - 1], trip.nodes[i]);
    trip.keeps_limits = trip.keeps_limits && leg.keeps_limits(trip.error[i - 1], trip.leg_m[i]);
    trip.error[i] = leg.after(trip.error[i - 1], trip.leg_m[i]);
  }
}

void leave_room(const CorrectionGraph& graph, Trip& trip) {
  trip.room.assign(trip.nodes.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = trip.last(); i > 0; --i) {
    const ReducedLeg& leg = graph.leg(trip.nodes[i - 1], trip.nodes[i]);
    const double fresh = leg.fresh_rate * trip.leg_m[i];
    const bool may_fly = fresh <= leg.fresh_most && (leg.carries_on || fresh <= trip.room[i]);
    const double most = leg.carries_on ? std::min(leg.carried_most, trip.room[i]) : leg.carried_most;
    trip.room[i - 1] = may_fly ? most - leg.carried_rate * trip.leg_m[i] : -1;
  }
}

}  // namespace

void fly(const CorrectionGraph& graph, std::span<const CorrectionGraph::Node> points, Trip& trip) {
  trip.nodes.assign(1, graph.start());
  trip.nodes.insert(trip.nodes.end(), points.begin(), points.end());
  trip.nodes.push_back(graph.goal());
  measure_legs(graph, trip);
  carry_errors(graph, trip);
  leave_room(graph, trip);
}

Trip fly(const CorrectionGraph& graph, std::span<const CorrectionGraph::Node> points) {
  Trip trip;
  fly(graph, points, trip);
  return trip;
}

bool is_free(const CorrectionGraph& graph, const Trip& trip) {
  for (std::size_t i = 1; i < trip.nodes.size(); ++i)
    if (!graph.is_free(trip.nodes[i - 1], trip.nodes[i])) return false;
  return true;
}

}  // namespace alate
