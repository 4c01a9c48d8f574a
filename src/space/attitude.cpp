#include "space/attitude.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "space/approach.hpp"
#include "space/lower_bound.hpp"

namespace alate {

namespace {

/// Routes may be this much longer than the direct distance; gives the paper's limit of 40 steps.
constexpr double kDetour = 3.4;
constexpr double kMaxSteps = 1e5;
/// Rounding grows by 1e-16 a step; squaring up the axes now and then keeps it there.
constexpr int kOrthonormaliseEvery = 64;
/// Bins at scale 1, in steps and radians.
constexpr double kCellSteps = 0.5;
constexpr double kLayerSteps = 0.125;
constexpr double kDirectionBin = kPi / 12;

LegLimits leg_limits(const Vehicle& vehicle) {
  LegLimits limits;
  if (vehicle.climb_rad) limits.max_sine = std::sin(std::min(*vehicle.climb_rad, kPi / 2));
  if (vehicle.descent_rad) limits.min_sine = -std::sin(std::min(*vehicle.descent_rad, kPi / 2));
  limits.turn_radius_m = vehicle.turn_radius_m.value_or(0);
  return limits;
}

/// Radius of the polygon that the sharpest moves in a row fly.
double tightest_turn(const Vehicle& vehicle, const RotationSet& rotations) {
  const double half_turn = std::max(rotations.largest_turn() / 2, 1e-6);
  return std::max(vehicle.turn_radius_m.value_or(0), *vehicle.step_m / (2 * std::sin(half_turn)));
}

std::size_t automatic_limit(const Site& site) {
  const double direct = (site.mission.goal - site.mission.start).norm();
  const double steps = std::max(1.0, std::round(kDetour * direct / *site.vehicle.step_m));
  const double within_range = std::floor(site.vehicle.range_m.value_or(kInfinity) / *site.vehicle.step_m);
  return static_cast<std::size_t>(std::min({steps, within_range, kMaxSteps}));
}

Mat3 orthonormalised(const Mat3& attitude) {
  const Vec3 forward = attitude.col(0).normalized();
  const Vec3 up = forward.cross(attitude.col(1)).normalized();
  Mat3 result;
  result << forward, up.cross(forward), up;
  return result;
}

/// Whole-number part for a bin key, in `bits` bits.
std::uint64_t part(double value, unsigned bits) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value))) & ((1U << bits) - 1U);
}

}  // namespace

AttitudeSpace::AttitudeSpace(const World& world, const CostToGo* guidance, const AttitudeOptions& options)
    : world_(world),
      site_(world.site()),
      guidance_(guidance),
      objective_(world, options.threats_at),
      rotations_(site_.vehicle),
      step_m_(*site_.vehicle.step_m),
      turn_radius_m_(tightest_turn(site_.vehicle, rotations_)),
      limits_(leg_limits(site_.vehicle)),
      step_limit_(options.step_limit == 0 ? automatic_limit(site_) : options.step_limit) {}

AttitudeState AttitudeSpace::start() const {
  return {.position = site_.mission.start, .attitude = level_attitude(site_.mission.heading_rad), .step = 0};
}

void AttitudeSpace::expand(const State& state, Candidates& out) const {
  const BodyPose pose{.position = state.position, .attitude = state.attitude};
  place_candidates(rotations_, pose, step_m_, out);
  measure_to_goal(site_.mission.goal, out);
  set_base_costs(base_costs(state), out);
  objective_.add_costs(pose, out);
  fill_guide(out);
}

BaseCosts AttitudeSpace::base_costs(const State& state) const {
  const bool at_start = state.step == 0;
  BaseCosts base{
      .limits = limits_, .step_m = step_m_, .before = step_m_ * state.attitude.col(0), .before_is_heading = at_start};
  if (at_start && !site_.mission.heading_given) base.limits.turn_radius_m = 0;
  if (objective_.is_physical()) {
    base.leg_cost = objective_.weights().length * step_m_;
    base.climb_cost = objective_.weights().climb;
  }
  return base;
}

double AttitudeSpace::move_cost(const State& from, const State& to) const {
  if (!within_limits(base_costs(from), to.position - from.position)) return kInfinity;
  return objective_.leg_cost({from.position, to.position});
}

void AttitudeSpace::fill_guide(Candidates& out) const {
  const double tolerance = site_.mission.tolerance_m;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (out.cost[k] == kInfinity) {
      out.guide[k] = kInfinity;
    } else if (!objective_.is_physical()) {
      out.guide[k] = node_bound(out.to_goal[k], objective_.weights().fuel, step_m_, tolerance);
    } else {
      const Vec3 end{out.x[k], out.y[k], out.z[k]};
      const Vec2 to_goal = (site_.mission.goal - end).head<2>();
      out.guide[k] =
          (guidance_ != nullptr ? (*guidance_)(end) : physical_bound(site_, end)) +
          objective_.weights().length * approach_detour(to_goal, {out.ux[k], out.uy[k]}, turn_radius_m_, tolerance);
    }
  }
}

bool AttitudeSpace::arrives(const Candidates& candidates, std::size_t k) const {
  return candidates.to_goal[k] <= site_.mission.tolerance_m;
}

AttitudeState AttitudeSpace::next(const State& state, std::size_t k) const {
  State result{.attitude = state.attitude * rotations_.matrix(k), .step = state.step + 1};
  result.position = state.position + step_m_ * result.attitude.col(0);
  if (result.step % kOrthonormaliseEvery == 0) result.attitude = orthonormalised(result.attitude);
  return result;
}

bool AttitudeSpace::is_free(const State& from, const State& to) const {
  return world_.is_free({from.position, to.position});
}

bool AttitudeSpace::is_goal(const State& state) const {
  return (state.position - site_.mission.goal).norm() <= site_.mission.tolerance_m;
}

double AttitudeSpace::lower_bound(const State& state) const {
  if (objective_.is_physical()) return physical_bound(site_, state.position);
  return node_bound((state.position - site_.mission.goal).norm(), objective_.weights().fuel, step_m_,
                    site_.mission.tolerance_m);
}

std::uint64_t AttitudeSpace::bin(const State& state, double scale) const {
  const Vec3 from_start = (state.position - site_.mission.start) / (step_m_ * scale);
  const Vec3 forward = state.attitude.col(0);
  const double heading = std::atan2(forward.y(), forward.x()) + kPi;
  const double slope = std::asin(std::clamp(forward.z(), -1.0, 1.0)) + kPi;
  const std::uint64_t direction =
      (part(heading / (scale * kDirectionBin), 10) << 10U) | part(slope / (scale * kDirectionBin), 10);
  return (part(from_start.x() / kCellSteps, 15) << 49U) | (part(from_start.y() / kCellSteps, 15) << 34U) |
         (part(from_start.z() / kLayerSteps, 14) << 20U) | direction;
}

double AttitudeSpace::problem_bound() const {
  const State from = start();
  if (is_goal(from)) return 0;
  const double plain = lower_bound(from);
  if (objective_.is_physical() || !site_.mission.heading_given) return plain;
  return std::max(plain, turn_limited_node_bound(site_, rotations_.largest_turn()));
}

}  // namespace alate
