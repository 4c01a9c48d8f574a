#include "space/objective.hpp"

#include <algorithm>

namespace alate {

namespace {

NodeThreat node_threat(const Threat& threat, double weight) {
  NodeThreat node{.center = threat.center, .radius_m = threat.radius_m, .weight = weight * threat.level};
  if (threat.shape == Threat::Shape::cylinder) {
    node.use_z = 0;
    node.floor_m = threat.floor_m;
    node.top_m = threat.top_m;
  }
  return node;
}

}  // namespace

Objective::Objective(const World& world) : world_(world), weights_(world.site().scenario.objective) {
  for (const Threat& threat : world.site().threats) threats_.push_back(node_threat(threat, weights_.threat));
}

double Objective::leg_cost(const Segment& leg) const {
  if (!is_physical()) return node_cost(leg.b);
  return weights_.length * leg.length() + weights_.threat * world_.exposure(leg) +
         weights_.climb * std::max(0.0, leg.b.z() - leg.a.z());
}

double Objective::node_cost(const Vec3& node) const {
  double cost = weights_.fuel * (node - world_.site().mission.goal).norm();
  for (const NodeThreat& threat : threats_) {
    if (node.z() < threat.floor_m || node.z() > threat.top_m) continue;
    Vec3 offset = node - threat.center;
    offset.z() *= threat.use_z;
    cost += threat.weight * std::max(0.0, threat.radius_m - offset.norm());
  }
  return cost;
}

double Objective::route_cost(const Route& route) const {
  double cost = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) cost += leg_cost(route.segment(i));
  return cost;
}

void Objective::add_costs(const Pose& pose, Candidates& out) const {
  if (!is_physical()) {
    add_node_costs(weights_.fuel, threats_, out);
    return;
  }
  if (out.size() == 0 || !near_threat(pose.position, (Vec3(out.x[0], out.y[0], out.z[0]) - pose.position).norm()))
    return;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (out.cost[k] == kInfinity) continue;
    out.cost[k] += weights_.threat * world_.exposure({pose.position, {out.x[k], out.y[k], out.z[k]}});
  }
}

bool Objective::near_threat(const Vec3& position, double reach_m) const {
  return std::ranges::any_of(threats_, [&](const NodeThreat& threat) {
    return (position - threat.center).head<2>().norm() < threat.radius_m + 1.001 * reach_m;
  });
}

}  // namespace alate
