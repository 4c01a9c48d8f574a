#include "space/ant_kernel.hpp"

#include <bit>
#include <cmath>

#include "space/simd.hpp"

namespace alate {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

const float* aligned(const AlignedFloats& array) {
  return static_cast<const float*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}
float* aligned(AlignedFloats& array) { return static_cast<float*>(__builtin_assume_aligned(array.data(), kSimdBytes)); }

/// Tells the compiler that there is no rest.
std::size_t whole(const AlignedFloats& array) { return array.size() & ~std::size_t{15}; }

struct Axis {
  float f0, f1, f2, from;
};

ALATE_SIMD void place_along(const MoveMatrices& moves, const Axis& axis, AlignedFloats& end) {
  const std::size_t count = whole(end);
  const float* __restrict bx = aligned(moves[0]);
  const float* __restrict by = aligned(moves[3]);
  const float* __restrict bz = aligned(moves[6]);
  float* __restrict x = aligned(end);
  const auto [f0, f1, f2, from] = axis;
  for (std::size_t k = 0; k < count; ++k) x[k] = from + (f0 * bx[k] + f1 * by[k] + f2 * bz[k]);
}

ALATE_SIMD void price_goal(const NodeModel& model, Choices& out) {
  const std::size_t count = whole(out.x);
  const float* __restrict x = aligned(out.x);
  const float* __restrict y = aligned(out.y);
  const float* __restrict z = aligned(out.z);
  float* __restrict to_goal = aligned(out.to_goal);
  float* __restrict cost = aligned(out.cost);
  const float gx = model.goal_x;
  const float gy = model.goal_y;
  const float gz = model.goal_z;
  const float fuel = model.fuel;
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - gx;
    const float dy = y[k] - gy;
    const float dz = z[k] - gz;
    const float d = std::sqrt(dx * dx + dy * dy + dz * dz);
    to_goal[k] = d;
    cost[k] = fuel * d;  // eq. (33)
  }
}

/// node_bound of lower_bound.hpp: whole steps until within the tolerance, but no farther than the goal.
ALATE_SIMD void guide_to_goal(const NodeModel& model, Choices& out) {
  const std::size_t count = whole(out.x);
  const float* __restrict to_goal = aligned(out.to_goal);
  float* __restrict guide = aligned(out.guide);
  const float fuel = model.fuel;
  const float half_step = 0.5F * model.step;
  const float per_step = 1 / model.step;
  const float tolerance = model.tolerance;
  for (std::size_t k = 0; k < count; ++k) {
    const float d = to_goal[k];
    const float left = (d - tolerance) * per_step;
    const float far = 0.5F * (left + std::abs(left));  // max(0, left) without a branch
    const auto full = static_cast<float>(static_cast<int>(far));
    const float needed = full + (far > full ? 1.0F : 0.0F);
    const auto fit = static_cast<float>(static_cast<int>(d * per_step));
    const float counted = needed < fit ? needed : fit;
    guide[k] = fuel * (counted * d - half_step * counted * (counted + 1));
  }
}

ALATE_SIMD void price_threat(const NodeModel::Sphere& sphere, Choices& out) {
  const std::size_t count = whole(out.x);
  const float* __restrict x = aligned(out.x);
  const float* __restrict y = aligned(out.y);
  const float* __restrict z = aligned(out.z);
  float* __restrict cost = aligned(out.cost);
  const auto [cx, cy, cz, radius, weight, use_z, floor, top] = sphere;
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - cx;
    const float dy = y[k] - cy;
    const float dz = (z[k] - cz) * use_z;
    const float depth = radius - std::sqrt(dx * dx + dy * dy + dz * dz);
    const bool inside = (depth > 0) & (z[k] >= floor) & (z[k] <= top);
    cost[k] += inside ? weight * depth : 0.0F;  // eq. (34)
  }
}

ALATE_SIMD void turn_row(const MoveMatrices& moves, const Axis& row, std::size_t first, MoveMatrices& out) {
  const std::size_t count = whole(out[first]);
  const auto [f0, f1, f2, unused] = row;
  for (std::size_t column = 0; column < 3; ++column) {
    const float* __restrict bx = aligned(moves[column]);
    const float* __restrict by = aligned(moves[3 + column]);
    const float* __restrict bz = aligned(moves[6 + column]);
    float* __restrict g = aligned(out[first + column]);
    for (std::size_t k = 0; k < count; ++k) g[k] = f0 * bx[k] + f1 * by[k] + f2 * bz[k];
  }
}

/// Where the node at body coordinates `q` lies, in `nodes`.
ALATE_SIMD void place_tail(const MoveMatrices& g, const TailNode& q, const Choices& ends, Choices& nodes) {
  const std::size_t count = whole(ends.x);
  const std::array<const AlignedFloats*, 3> from{&ends.x, &ends.y, &ends.z};
  const std::array<AlignedFloats*, 3> to{&nodes.x, &nodes.y, &nodes.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const float* __restrict gx = aligned(g[3 * i]);
    const float* __restrict gy = aligned(g[3 * i + 1]);
    const float* __restrict gz = aligned(g[3 * i + 2]);
    const float* __restrict start = aligned(*from[i]);
    float* __restrict end = aligned(*to[i]);
    const auto [qx, qy, qz] = q;
    for (std::size_t k = 0; k < count; ++k) end[k] = start[k] + (gx[k] * qx + gy[k] * qy + gz[k] * qz);
  }
}

ALATE_SIMD float add_sums(float tolerance, const Choices& nodes, TailSums& sums) {
  const std::size_t count = whole(nodes.x);
  const float* __restrict cost = aligned(nodes.cost);
  const float* __restrict to_goal = aligned(nodes.to_goal);
  const float* __restrict guide = aligned(nodes.guide);
  float* __restrict sum = aligned(sums.sum);
  float* __restrict total = aligned(sums.total);
  for (std::size_t k = 0; k < count; ++k) {
    sum[k] += cost[k];
    const bool first_arrival = (to_goal[k] <= tolerance) & (total[k] == kNever);
    total[k] = first_arrival ? sum[k] : total[k];
  }
  // Bits of floats from 0 up are in order, and least whole numbers vectorise.
  std::int32_t least = std::bit_cast<std::int32_t>(kNever);
  for (std::size_t k = 0; k < count; ++k) {
    const float reachable = sum[k] + guide[k];
    const auto open = std::bit_cast<std::int32_t>(total[k] == kNever ? reachable : kNever);
    least = open < least ? open : least;
  }
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

}  // namespace

MoveMatrices move_matrices(const RotationSet& rotations) {
  MoveMatrices result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      AlignedFloats& array = result[static_cast<std::size_t>(3 * row + column)];
      array.resize(padded_size(rotations.size()));
      for (std::size_t k = 0; k < rotations.size(); ++k)
        array[k] = static_cast<float>(rotations.matrix(k)(row, column));
    }
  }
  return result;
}

AntPose::AntPose(const Vec3& from_start, const Mat3& f) {
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
  AlignedFloats* const ends[] = {&out.x, &out.y, &out.z};
  for (std::size_t i = 0; i < 3; ++i) {
    auto [f0, f1, f2, from] = axis_of(pose, i);
    place_along(moves, {step * f0, step * f1, step * f2, from}, *ends[i]);
  }
}

void price_choices(const NodeModel& model, Choices& out) {
  price_goal(model, out);
  guide_to_goal(model, out);
  // The threats are the outer loop: with them inside, the choices would not vectorise.
  for (const NodeModel::Sphere& sphere : model.threats) price_threat(sphere, out);
}

void price_step(const NodeModel& model, const AntPose& pose, Choices& out) {
  price_goal(model, out);
  guide_to_goal(model, out);
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

float add_tail_node(const NodeModel& model, const MoveMatrices& attitudes, const TailNode& q, const Choices& ends,
                    Choices& nodes, TailSums& sums) {
  place_tail(attitudes, q, ends, nodes);
  price_choices(model, nodes);
  return add_sums(model.tolerance, nodes, sums);
}

void measure_tail_node(const NodeModel& model, const MoveMatrices& attitudes, const TailNode& q, const Choices& ends,
                       Choices& nodes) {
  place_tail(attitudes, q, ends, nodes);
  price_goal(model, nodes);
}

}  // namespace alate
