#include "space/ant_kernel.hpp"

#include <bit>
#include <cmath>

#include "space/simd.hpp"

namespace alate {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

struct Axis {
  float f0, f1, f2, from;

  float end(float bx, float by, float bz) const { return from + (f0 * bx + f1 * by + f2 * bz); }
};

/// The part of the node model that knows of the goal, prepared for many nodes.
struct GoalCosts {
  float x, y, z, fuel, tolerance, half_step, per_step;

  explicit GoalCosts(const NodeModel& model)
      : x(model.goal_x),
        y(model.goal_y),
        z(model.goal_z),
        fuel(model.fuel),
        tolerance(model.tolerance),
        half_step(0.5F * model.step),
        per_step(1 / model.step) {}

  float distance(float px, float py, float pz) const {
    const float dx = px - x;
    const float dy = py - y;
    const float dz = pz - z;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }

  /// node_bound of lower_bound.hpp: whole steps until within the tolerance, but no farther than the goal.
  float guide(float d) const {
    const float left = (d - tolerance) * per_step;
    const float far = 0.5F * (left + std::abs(left));  // max(0, left) without a branch
    const auto full = static_cast<float>(static_cast<int>(far));
    const float needed = full + (far > full ? 1.0F : 0.0F);
    const auto fit = static_cast<float>(static_cast<int>(d * per_step));
    const float counted = needed < fit ? needed : fit;
    return fuel * (counted * d - half_step * counted * (counted + 1));
  }
};

ALATE_SIMD void place_along(const MoveMatrices& moves, const Axis& axis, AlignedFloats& ends) {
  const auto body = [a = axis](float& end, float bx, float by, float bz) { end = a.end(bx, by, bz); };
  for_each_lane(body, ends, moves[0], moves[3], moves[6]);
}

/// What does not depend on threats, in one pass: where the choices lead, J and h.
ALATE_SIMD void place_and_price(const NodeModel& model, const MoveMatrices& moves, const std::array<Axis, 3>& axes,
                                Choices& out) {
  const GoalCosts goal(model);
  const auto body = [=, ax = axes[0], ay = axes[1], az = axes[2]](float& x, float& y, float& z, float& to_goal,
                                                                  float& cost, float& guide, float bx, float by,
                                                                  float bz) {
    // Written only once all is known: what is written might have to be read again.
    const float px = ax.end(bx, by, bz);
    const float py = ay.end(bx, by, bz);
    const float pz = az.end(bx, by, bz);
    const float d = goal.distance(px, py, pz);
    const float ahead = goal.guide(d);
    x = px;
    y = py;
    z = pz;
    to_goal = d;
    cost = goal.fuel * d;  // eq. (33)
    guide = ahead;
  };
  for_each_lane(body, out.x, out.y, out.z, out.to_goal, out.cost, out.guide, moves[0], moves[3], moves[6]);
}

ALATE_SIMD void price_goal(const NodeModel& model, Choices& out) {
  const auto body = [goal = GoalCosts(model)](float& to_goal, float& cost, float& guide, float x, float y, float z) {
    const float d = goal.distance(x, y, z);
    const float ahead = goal.guide(d);
    to_goal = d;
    cost = goal.fuel * d;
    guide = ahead;
  };
  for_each_lane(body, out.to_goal, out.cost, out.guide, out.x, out.y, out.z);
}

ALATE_SIMD void price_threat(const NodeModel::Sphere& sphere, Choices& out) {
  const auto body = [s = sphere](float& cost, float x, float y, float z) {
    const float dx = x - s.x;
    const float dy = y - s.y;
    const float dz = (z - s.z) * s.use_z;
    const float depth = s.radius - std::sqrt(dx * dx + dy * dy + dz * dz);
    const bool inside = (depth > 0) & (z >= s.floor) & (z <= s.top);
    cost += inside ? s.weight * depth : 0.0F;  // eq. (34)
  };
  for_each_lane(body, out.cost, out.x, out.y, out.z);
}

ALATE_SIMD void turn_row(const MoveMatrices& moves, const Axis& row, std::size_t first, MoveMatrices& out) {
  const auto body = [a = row](float& g, float bx, float by, float bz) { g = a.f0 * bx + a.f1 * by + a.f2 * bz; };
  for (std::size_t column = 0; column < 3; ++column)
    for_each_lane(body, out[first + column], moves[column], moves[3 + column], moves[6 + column]);
}

/// Where the node at body coordinates `q` lies, in `nodes`.
ALATE_SIMD void place_tail(const MoveMatrices& g, const TailNode& tail, const Choices& ends, Choices& nodes) {
  const auto body = [q = tail](float& end, float start, float gx, float gy, float gz) {
    end = start + (gx * q.x + gy * q.y + gz * q.z);
  };
  for_each_lane(body, nodes.x, ends.x, g[0], g[1], g[2]);
  for_each_lane(body, nodes.y, ends.y, g[3], g[4], g[5]);
  for_each_lane(body, nodes.z, ends.z, g[6], g[7], g[8]);
}

ALATE_SIMD float add_sums(float tolerance, const Choices& nodes, TailSums& sums) {
  // Bits of floats from 0 up are in order, and least whole numbers vectorise.
  auto least = std::bit_cast<std::int32_t>(kNever);
  const auto body = [tolerance, &least](float& sum, float& total, float cost, float to_goal, float guide) {
    sum += cost;
    const bool first_arrival = (to_goal <= tolerance) & (total == kNever);
    total = first_arrival ? sum : total;
    const auto open = std::bit_cast<std::int32_t>(total == kNever ? sum + guide : kNever);
    least = open < least ? open : least;
  };
  for_each_lane(body, sums.sum, sums.total, nodes.cost, nodes.to_goal, nodes.guide);
  return std::bit_cast<float>(least);
}

/// Can a step from here end inside?
bool reaches(const NodeModel::Sphere& sphere, const AntPose& pose, float step) {
  const float dx = pose.position[0] - sphere.x;
  const float dy = pose.position[1] - sphere.y;
  const float dz = (pose.position[2] - sphere.z) * sphere.use_z;
  const float reach = sphere.radius + 1.001F * step;
  return dx * dx + dy * dy + dz * dz < reach * reach;
}

Axis axis_of(const AntPose& pose, std::size_t i) {
  return {pose.attitude[3 * i], pose.attitude[3 * i + 1], pose.attitude[3 * i + 2], pose.position[i]};
}

/// The columns scaled by the step, so that a choice costs nine multiplications.
std::array<Axis, 3> step_axes(const AntPose& pose, float step) {
  std::array<Axis, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [f0, f1, f2, from] = axis_of(pose, i);
    axes[i] = {step * f0, step * f1, step * f2, from};
  }
  return axes;
}

}  // namespace

MoveMatrices move_matrices(const RotationSet& rotations) {
  MoveMatrices result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const int place = 3 * row + column;
      AlignedFloats& array = result[static_cast<std::size_t>(place)];
      array.resize(padded_size(rotations.size()));
      for (std::size_t k = 0; k < rotations.size(); ++k)
        array[k] = static_cast<float>(rotations.matrix(k)(row, column));
    }
  }
  return result;
}

AntPose::AntPose(const Vec3& from_start, const Mat3& f) : position(), attitude() {
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    position[row] = static_cast<float>(from_start[i]);
    for (int j = 0; j < 3; ++j) attitude[3 * row + static_cast<std::size_t>(j)] = static_cast<float>(f(i, j));
  }
}

NodeModel::NodeModel(const Site& site, const std::vector<NodeThreat>& node_threats)
    : goal_x(static_cast<float>(site.mission.goal.x() - site.mission.start.x())),
      goal_y(static_cast<float>(site.mission.goal.y() - site.mission.start.y())),
      goal_z(static_cast<float>(site.mission.goal.z() - site.mission.start.z())),
      fuel(static_cast<float>(site.scenario.objective.fuel)),
      step(static_cast<float>(site.vehicle.step_m.value_or(1))),
      tolerance(static_cast<float>(site.mission.tolerance_m)) {
  const Vec3& start = site.mission.start;
  for (const NodeThreat& threat : node_threats) {
    const Vec3 center = threat.center - start;
    threats.push_back({.x = static_cast<float>(center.x()),
                       .y = static_cast<float>(center.y()),
                       .z = static_cast<float>(center.z()),
                       .radius = static_cast<float>(threat.radius_m),
                       .weight = static_cast<float>(threat.weight),
                       .use_z = static_cast<float>(threat.use_z),
                       .floor = static_cast<float>(threat.floor_m - start.z()),
                       .top = static_cast<float>(threat.top_m - start.z())});
  }
}

void place_choices(const MoveMatrices& moves, const AntPose& pose, float step, Choices& out) {
  const std::array<Axis, 3> axes = step_axes(pose, step);
  place_along(moves, axes[0], out.x);
  place_along(moves, axes[1], out.y);
  place_along(moves, axes[2], out.z);
}

void price_choices(const NodeModel& model, Choices& out) {
  price_goal(model, out);
  // The threats are the outer loop: with them inside, the choices would not vectorise.
  for (const NodeModel::Sphere& sphere : model.threats) price_threat(sphere, out);
}

void look_one_step(const NodeModel& model, const MoveMatrices& moves, const AntPose& pose, Choices& out) {
  place_and_price(model, moves, step_axes(pose, model.step), out);
  for (const NodeModel::Sphere& sphere : model.threats)
    if (reaches(sphere, pose, model.step)) price_threat(sphere, out);
}

void turn_moves(const MoveMatrices& moves, const AntPose& pose, MoveMatrices& out) {
  for (std::size_t i = 0; i < 9; ++i) out[i].resize(moves[i].size());
  for (std::size_t i = 0; i < 3; ++i) turn_row(moves, axis_of(pose, i), 3 * i, out);
}

float start_tails(float cost_before, float tolerance, const Choices& ends, TailSums& sums) {
  sums.sum.assign(ends.x.size(), cost_before);
  sums.total.assign(ends.x.size(), kNever);
  return add_sums(tolerance, ends, sums);
}

float add_tail_node(const NodeModel& model, const TailStep& step, Choices& nodes, TailSums& sums) {
  place_tail(step.attitudes, step.node, step.ends, nodes);
  price_choices(model, nodes);
  return add_sums(model.tolerance, nodes, sums);
}

void measure_tail_node(const NodeModel& model, const TailStep& step, Choices& nodes) {
  place_tail(step.attitudes, step.node, step.ends, nodes);
  price_goal(model, nodes);
}

}  // namespace alate
