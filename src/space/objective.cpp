#include "space/objective.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <vector>

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

/// Parts of an arc, in (0, 1), at which it comes into a threat or leaves it, or passes floor or top of a cylinder; from
/// 0 to 1 and in order. The density bends there, which quadrature is slow to find out. Rounding errors do no harm.
std::vector<double> bends(const Threat& threat, const Helix& arc) {
  const Vec2 out = arc.from.head<2>() - arc.center;
  const Vec2 middle = threat.center.head<2>() - arc.center;
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  std::vector<double> parts{0, 1};
  const auto add = [&](double t) {
    if (t > 0 && t < 1) parts.push_back(t);
  };
  const double apart = 2 * out.norm() * middle.norm();
  if (apart > 0 && arc.angle_rad != 0) {
    const double between = std::atan2(out.y(), out.x()) - std::atan2(middle.y(), middle.x());
    const double turns = arc.angle_rad / (2 * kPi);
    // The aircraft is at `between - angle t`, seen from the arc's centre; at +-acos it is as far as the threat reaches.
    for (const int side : {-1, 1}) {
      for (int turn = static_cast<int>(-std::abs(turns)) - 2; turn <= static_cast<int>(std::abs(turns)) + 2; ++turn) {
        double t = 0.5;
        constexpr int kSteps = 5;  // of a fixed point, for spheres are as wide as the altitude lets them
        for (int step = 0; step < kSteps; ++step) {
          const double above = cylinder ? 0 : arc.from.z() + std::clamp(t, 0.0, 1.0) * arc.rise_m - threat.center.z();
          const double squared = threat.radius_m * threat.radius_m - above * above;
          const double cosine = (out.squaredNorm() + middle.squaredNorm() - squared) / apart;
          t = (between + side * std::acos(cosine) + 2 * kPi * turn) / arc.angle_rad;
        }
        add(t);  // what is no number is nowhere
      }
    }
  }
  if (cylinder && arc.rise_m != 0)
    for (const double z : {threat.floor_m, threat.top_m}) add((z - arc.from.z()) / arc.rise_m);
  std::ranges::sort(parts);
  return parts;
}

double exposure(const Threat& threat, const Helix& arc) {
  const Vec2 middle = arc.center - threat.center.head<2>();
  const double radius = (arc.from.head<2>() - arc.center).norm();
  const double away = (arc.from - threat.center).head<2>().norm();
  if (middle.norm() - radius > threat.radius_m || away - arc.planar_m() > threat.radius_m) return 0;
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  const auto density = [&](double t) {
    const Vec3 at = arc.at(t);
    if (cylinder && (at.z() < threat.floor_m || at.z() > threat.top_m)) return 0.0;
    Vec3 offset = at - threat.center;
    if (cylinder) offset.z() = 0;
    return std::max(0.0, 1 - offset.norm() / threat.radius_m);
  };
  // Between bends the density is smooth; more would be spent on rounding errors where hardly anything is seen.
  constexpr unsigned kDepth = 4;
  constexpr double kTolerance = 1e-9;
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  const std::vector<double> parts = bends(threat, arc);
  double sum = 0;
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (parts[i] > parts[i - 1]) sum += Rule::integrate(density, parts[i - 1], parts[i], kDepth, kTolerance);
  return threat.level * arc.length() * sum;
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
