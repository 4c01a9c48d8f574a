#include "space/attitude_kernel.hpp"

#include <cmath>

#include "space/simd.hpp"

namespace alate {

namespace {

/// Turn and slope limits hold to rounding: an angle of the set that equals a limit is allowed.
constexpr double kSlack = 1e-9;

/// An aligned array of the structure, for loops that the compiler can vectorise.
const double* aligned(const AlignedDoubles& array) {
  return static_cast<const double*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}
double* aligned(AlignedDoubles& array) {
  return static_cast<double*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}

/// One row of F and one coordinate of the position.
struct Axis {
  double f0, f1, f2;
  double from;
};

ALATE_SIMD void place_along(const RotationSet& rotations, const Axis& axis, double step_m, AlignedDoubles& direction,
                            AlignedDoubles& end) {
  const std::size_t count = rotations.size();
  const double* __restrict bx = aligned(rotations.forward_x());
  const double* __restrict by = aligned(rotations.forward_y());
  const double* __restrict bz = aligned(rotations.forward_z());
  double* __restrict u = aligned(direction);
  double* __restrict x = aligned(end);
  const auto [f0, f1, f2, from] = axis;
  for (std::size_t k = 0; k < count; ++k) {
    u[k] = f0 * bx[k] + f1 * by[k] + f2 * bz[k];
    x[k] = from + step_m * u[k];
  }
}

ALATE_SIMD void measure_to(const Vec3& goal, Candidates& out) {
  const std::size_t count = out.size();
  const double* __restrict x = aligned(out.x);
  const double* __restrict y = aligned(out.y);
  const double* __restrict z = aligned(out.z);
  double* __restrict to_goal = aligned(out.to_goal);
  const double gx = goal.x();
  const double gy = goal.y();
  const double gz = goal.z();
  for (std::size_t k = 0; k < count; ++k) {
    const double dx = x[k] - gx;
    const double dy = y[k] - gy;
    const double dz = z[k] - gz;
    to_goal[k] = std::sqrt(dx * dx + dy * dy + dz * dz);
  }
}

}  // namespace

void place_candidates(const RotationSet& rotations, const Pose& pose, double step_m, const Vec3& goal,
                      Candidates& out) {
  out.resize(rotations.size());
  const auto axis = [&](int i) {
    return Axis{pose.attitude(i, 0), pose.attitude(i, 1), pose.attitude(i, 2), pose.position[i]};
  };
  place_along(rotations, axis(0), step_m, out.ux, out.x);
  place_along(rotations, axis(1), step_m, out.uy, out.y);
  place_along(rotations, axis(2), step_m, out.uz, out.z);
  measure_to(goal, out);
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
    return (radius * cross <= 0.5 * usable_m * denominator) & (sine <= max_sine) & (sine >= min_sine);
  }
};

}  // namespace

ALATE_SIMD void set_base_costs(const BaseCosts& base, Candidates& out) {
  const std::size_t count = out.size();
  const double* __restrict ux = aligned(out.ux);
  const double* __restrict uy = aligned(out.uy);
  const double* __restrict uz = aligned(out.uz);
  double* __restrict cost = aligned(out.cost);
  const double s = base.step_m;
  const LegTest test(base);
  for (std::size_t k = 0; k < count; ++k) {
    const double rise_m = uz[k] > 0 ? s * uz[k] : 0.0;
    const double price = base.leg_cost + base.climb_cost * rise_m;
    cost[k] = test.passes(s * ux[k], s * uy[k], uz[k]) ? price : kInfinity;
  }
}

bool within_limits(const BaseCosts& base, const Vec3& leg) {
  return LegTest(base).passes(leg.x(), leg.y(), leg.z() / base.step_m);
}

ALATE_SIMD void add_node_costs(double fuel, const std::vector<NodeThreat>& threats, Candidates& out) {
  const std::size_t count = out.size();
  const double* __restrict x = aligned(out.x);
  const double* __restrict y = aligned(out.y);
  const double* __restrict z = aligned(out.z);
  const double* __restrict to_goal = aligned(out.to_goal);
  double* __restrict cost = aligned(out.cost);
  for (std::size_t k = 0; k < count; ++k) cost[k] += fuel * to_goal[k];
  // The threats are the outer loop: with them inside, the candidates would not vectorise.
  for (const NodeThreat& threat : threats) {
    const auto [center, radius_m, weight, use_z, floor_m, top_m] = threat;
    const double cx = center.x();
    const double cy = center.y();
    const double cz = center.z();
    for (std::size_t k = 0; k < count; ++k) {
      const double dx = x[k] - cx;
      const double dy = y[k] - cy;
      const double dz = (z[k] - cz) * use_z;
      const double depth = radius_m - std::sqrt(dx * dx + dy * dy + dz * dz);
      const bool inside = (depth > 0) & (z[k] >= floor_m) & (z[k] <= top_m);
      cost[k] += inside ? weight * depth : 0.0;
    }
  }
}

}  // namespace alate
