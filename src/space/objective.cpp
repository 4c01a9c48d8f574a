#include "space/objective.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

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

/// A turn about an upright axis that climbs evenly.
struct Helix {
  Vec3 from;
  Vec2 center;
  double angle_rad;  ///< Clockwise positive.
  double rise_m;

  double planar_m() const { return (from.head<2>() - center).norm() * std::abs(angle_rad); }
  double length() const { return std::hypot(planar_m(), rise_m); }
  Vec3 at(double t) const {
    const Vec2 out = from.head<2>() - center;
    const double c = std::cos(angle_rad * t);
    const double s = std::sin(angle_rad * t);
    return {center.x() + c * out.x() + s * out.y(), center.y() + c * out.y() - s * out.x(), from.z() + t * rise_m};
  }
};

double exposure(const Threat& threat, const Helix& arc) {
  const Vec2 middle = arc.center - threat.center.head<2>();
  if (middle.norm() - (arc.from.head<2>() - arc.center).norm() > threat.radius_m) return 0;
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  const auto density = [&](double t) {
    const Vec3 at = arc.at(t);
    if (cylinder && (at.z() < threat.floor_m || at.z() > threat.top_m)) return 0.0;
    Vec3 offset = at - threat.center;
    if (cylinder) offset.z() = 0;
    return std::max(0.0, 1 - offset.norm() / threat.radius_m);
  };
  constexpr unsigned kDepth = 15;
  constexpr double kTolerance = 1e-9;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  return threat.level * arc.length() * Rule::integrate(density, 0.0, 1.0, kDepth, kTolerance);
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
  for (std::size_t i = 1; i < route.states.size(); ++i) {
    const Segment leg = route.segment(i);
    const auto& arc = route.states[i].arc;
    cost += arc && is_physical() ? arc_cost(leg, *arc) : leg_cost(leg);
  }
  return cost;
}

double Objective::arc_cost(const Segment& ends, const Arc& arc) const {
  const double rise = ends.b.z() - ends.a.z();
  const Helix helix{.from = ends.a, .center = arc.center, .angle_rad = arc.angle_rad, .rise_m = rise};
  double cost = weights_.length * helix.length() + weights_.climb * std::max(0.0, rise);
  for (const Threat& threat : world_.site().threats) cost += weights_.threat * exposure(threat, helix);
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
