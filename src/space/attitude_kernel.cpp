#include "space/attitude_kernel.hpp"

#include <cmath>

#include "space/simd.hpp"

namespace alate {

namespace {

/// Turn and slope limits hold to rounding: an angle of the set that equals a limit is allowed.
constexpr double kSlack = 1e-9;

/// One row of F and one coordinate of the position.
struct Axis {
  double f0, f1, f2;
  double from;
  double step_m;
};

ALATE_SIMD void place_along(const RotationSet& rotations, const Axis& axis, AlignedDoubles& direction,
                            AlignedDoubles& end) {
  const auto body = [a = axis](double& u, double& x, double bx, double by, double bz) {
    u = a.f0 * bx + a.f1 * by + a.f2 * bz;
    x = a.from + a.step_m * u;
  };
  for_each_lane(body, direction, end, rotations.forward_x(), rotations.forward_y(), rotations.forward_z());
}

/// Distance to a point, or to the axis through it.
struct Distance {
  double x, y, z;
  double use_z = 1;

  double operator()(double px, double py, double pz) const {
    const double dx = px - x;
    const double dy = py - y;
    const double dz = (pz - z) * use_z;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }
};

}  // namespace

void place_candidates(const RotationSet& rotations, const BodyPose& pose, double step_m, Candidates& out) {
  out.resize(rotations.size());
  const auto axis = [&](int i) {
    return Axis{pose.attitude(i, 0), pose.attitude(i, 1), pose.attitude(i, 2), pose.position[i], step_m};
  };
  place_along(rotations, axis(0), out.ux, out.x);
  place_along(rotations, axis(1), out.uy, out.y);
  place_along(rotations, axis(2), out.uz, out.z);
}

ALATE_SIMD void measure_to_goal(const Vec3& goal, Candidates& out) {
  const auto body = [to = Distance{goal.x(), goal.y(), goal.z()}](double& to_goal, double x, double y, double z) {
    to_goal = to(x, y, z);
  };
  for_each_lane(body, out.to_goal, out.x, out.y, out.z);
}

namespace {

/// The tests of one leg, prepared for all legs that start in one state.
struct LegTest {
  double ax, ay, before_m, usable_before_m, max_sine, min_sine, radius;

  explicit LegTest(const BaseCosts& base)
      : ax(base.before.x()),
        ay(base.before.y()),
        before_m(std::sqrt(ax * ax + ay * ay)),
        usable_before_m(base.before_is_heading ? kInfinity : before_m),
        max_sine(base.limits.max_sine + kSlack),
        min_sine(base.limits.min_sine - kSlack),
        radius(base.limits.turn_radius_m * (1 - kSlack)) {}

  bool passes(double bx, double by, double sine) const {
    const double after_m = std::sqrt(bx * bx + by * by);
    // tan(theta / 2) = |cross| / (|a| |b| + dot)
    const double cross = std::abs(ax * by - ay * bx);
    const double denominator = before_m * after_m + (ax * bx + ay * by);
    const double usable_m = usable_before_m < after_m ? usable_before_m : after_m;
    // Not &&: no branch, so that the loop vectorises.
    const int kept = static_cast<int>(radius * cross <= 0.5 * usable_m * denominator) &
                     static_cast<int>(sine <= max_sine) & static_cast<int>(sine >= min_sine);
    return kept != 0;
  }
};

}  // namespace

ALATE_SIMD void set_base_costs(const BaseCosts& base, Candidates& out) {
  const double s = base.step_m;
  const double leg_cost = base.leg_cost;
  const double climb_cost = base.climb_cost;
  const LegTest test(base);
  const auto body = [=](double& cost, double ux, double uy, double uz) {
    const double rise_m = uz > 0 ? s * uz : 0.0;
    const double price = leg_cost + climb_cost * rise_m;
    cost = test.passes(s * ux, s * uy, uz) ? price : kInfinity;
  };
  for_each_lane(body, out.cost, out.ux, out.uy, out.uz);
}

bool within_limits(const BaseCosts& base, const Vec3& leg) {
  return LegTest(base).passes(leg.x(), leg.y(), leg.z() / base.step_m);
}

ALATE_SIMD void add_node_costs(double fuel, const std::vector<NodeThreat>& threats, Candidates& out) {
  for_each_lane([fuel](double& cost, double to_goal) { cost += fuel * to_goal; }, out.cost, out.to_goal);
  // The threats are the outer loop: with them inside, the candidates would not vectorise.
  for (const NodeThreat& threat : threats) {
    const Distance from{threat.center.x(), threat.center.y(), threat.center.z(), threat.use_z};
    const auto body = [from, radius_m = threat.radius_m, weight = threat.weight, floor_m = threat.floor_m,
                       top_m = threat.top_m](double& cost, double x, double y, double z) {
      const double depth = radius_m - from(x, y, z);
      const bool inside = (depth > 0) & (z >= floor_m) & (z <= top_m);
      cost += inside ? weight * depth : 0.0;
    };
    for_each_lane(body, out.cost, out.x, out.y, out.z);
  }
}

}  // namespace alate
