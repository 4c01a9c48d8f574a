#include "space/objective.hpp"

#include <algorithm>

#include "world/threat_field.hpp"

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

Objective::Objective(const World& world, ThreatsAt threats_at)
    : world_(world), weights_(world.site().scenario.objective), threats_at_(threats_at) {
  for (const Threat& threat : world.site().threats) threats_.push_back(node_threat(threat, weights_.threat));
}

double Objective::leg_cost(const Segment& leg) const {
  if (!is_physical()) {
    const double fuel = weights_.fuel * (leg.b - world_.site().mission.goal).norm();
    return is_of_nodes() ? fuel + threat_at(leg.b) : fuel + mean_threat(leg);
  }
  return weights_.length * leg.length() + weights_.threat * world_.exposure(leg) +
         weights_.climb * std::max(0.0, leg.b.z() - leg.a.z());
}

double Objective::threat_at(const Vec3& node) const {
  double sum = 0;
  for (const NodeThreat& threat : threats_) {
    if (node.z() < threat.floor_m || node.z() > threat.top_m) continue;
    Vec3 offset = node - threat.center;
    offset.z() *= threat.use_z;
    sum += threat.weight * std::max(0.0, threat.radius_m - offset.norm());
  }
  return sum;
}

double Objective::mean_threat(const Segment& leg) const {
  double sum = 0;
  for (const Threat& threat : world_.site().threats) sum += threat.radius_m * exposure(threat, leg);
  return weights_.threat * sum / leg.length();
}

double Objective::route_cost(const Route& route) const {
  double cost = 0;
  for (std::size_t i = 1; i < route.states.size(); ++i) cost += leg_cost(route.segment(i));
  return cost;
}

void Objective::add_costs(const BodyPose& pose, Candidates& out) const {
  if (is_of_nodes()) {
    add_node_costs(weights_.fuel, threats_, out);
    return;
  }
  if (!is_physical()) add_node_costs(weights_.fuel, {}, out);
  if (out.size() == 0 || !near_threat(pose.position, (Vec3(out.x[0], out.y[0], out.z[0]) - pose.position).norm()))
    return;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (out.cost[k] == kInfinity) continue;
    const Segment leg{pose.position, {out.x[k], out.y[k], out.z[k]}};
    out.cost[k] += is_physical() ? weights_.threat * world_.exposure(leg) : mean_threat(leg);
  }
}

bool Objective::near_threat(const Vec3& position, double reach_m) const {
  return std::ranges::any_of(threats_, [&](const NodeThreat& threat) {
    return (position - threat.center).head<2>().norm() < threat.radius_m + 1.001 * reach_m;
  });
}

}  // namespace alate
