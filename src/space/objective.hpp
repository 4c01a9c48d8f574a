// What a leg costs under the scenario's objective.
#pragma once

#include <cstdint>

#include "alate/core/route.hpp"
#include "alate/world/world.hpp"
#include "space/attitude_kernel.hpp"

namespace alate {

/// Where konatowski2019 asks for threats. The physical model always takes them along legs.
enum class ThreatsAt : std::uint8_t { nodes, legs };

/// Both models are sums over legs, so a route's cost is the sum of leg_cost.
///
/// physical, metres: length * L + threat * exposure + climb * max(0, dz).
/// konatowski2019: fuel * |u - goal| + threat * sum level * max(0, r - |u - c|) at the node u that ends the leg; the
/// start is not counted, the arrival node is (Konatowski, Pawlowski 2019, eqs. (33), (34), (37)).
/// Departure on request: ThreatsAt::legs takes the mean of the threat along the leg instead of its value at the node,
/// so that no sphere is jumped unseen. That is another sum than the one `measure` reports.
class Objective {
 public:
  /// `world` must outlive this.
  explicit Objective(const World& world, ThreatsAt threats_at = ThreatsAt::nodes);

  double leg_cost(const Segment& leg) const;
  /// Arcs about upright axes count as they are flown under the physical model.
  double route_cost(const Route& route) const;

  /// Fills costs of candidates of one expansion; those out of K stay infinite.
  void add_costs(const BodyPose& pose, Candidates& out) const;

  const ObjectiveSpec& weights() const { return weights_; }
  const std::vector<NodeThreat>& node_threats() const { return threats_; }
  bool is_physical() const { return weights_.model == CostModel::physical; }
  /// Is the cost that of the node model as published?
  bool is_of_nodes() const { return !is_physical() && threats_at_ == ThreatsAt::nodes; }

 private:
  double arc_cost(const Segment& ends, const Arc& arc) const;
  bool near_threat(const Vec3& position, double reach_m) const;
  double threat_at(const Vec3& node) const;
  double mean_threat(const Segment& leg) const;

  const World& world_;
  const ObjectiveSpec& weights_;
  ThreatsAt threats_at_;
  std::vector<NodeThreat> threats_;
};

}  // namespace alate
