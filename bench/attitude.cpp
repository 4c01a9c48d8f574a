// One expansion of the attitude lattice: the kernel against the paper's rotations, candidate by candidate.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include "space/attitude.hpp"

namespace alate {
namespace {

constexpr double kFuel = 0.5;
constexpr double kThreat = 0.5;
constexpr double kStep = 2;
const Vec3 kGoal{20, 20, 10};

Vehicle vehicle() {
  Vehicle result;
  const std::vector<double> angles{radians(-15), radians(-7.5), 0, radians(7.5), radians(15)};
  result.roll_rad = result.pitch_rad = result.yaw_rad = angles;
  return result;
}

std::vector<NodeThreat> threats() {
  return {{.center = {11, 8, 6.5}, .radius_m = 4, .weight = kThreat * 0.5},
          {.center = {15, 12, 8}, .radius_m = 4, .weight = kThreat * 0.5},
          {.center = {17.5, 17, 9}, .radius_m = 3, .weight = kThreat * 0.5}};
}

BodyPose pose() { return {.position = {9, 5, 6}, .attitude = level_attitude(radians(50))}; }

void per_candidate(benchmark::State& state, std::size_t candidates) {
  state.counters["per_candidate"] = benchmark::Counter(
      static_cast<double>(candidates), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Constant body rotations, structure of arrays, threats outside the candidate loop.
void kernel(benchmark::State& state) {
  const RotationSet rotations(vehicle());
  const auto spheres = threats();
  const BodyPose from = pose();
  Candidates candidates;
  for (auto _ : state) {
    place_candidates(rotations, from, kStep, candidates);
    measure_to_goal(kGoal, candidates);
    set_base_costs({.step_m = kStep, .before = kStep * from.attitude.col(0)}, candidates);
    add_node_costs(kFuel, spheres, candidates);
    benchmark::DoNotOptimize(candidates.cost.data());
    benchmark::ClobberMemory();
  }
  per_candidate(state, rotations.size());
}
BENCHMARK(kernel);

/// The paper word by word: three rotations about the axes as they turn (eqs. (15)-(25)), then the cost.
void literal(benchmark::State& state) {
  const RotationSet rotations(vehicle());
  const auto spheres = threats();
  const BodyPose from = pose();
  std::vector<double> cost(rotations.size());
  const auto turn = [](const Mat3& attitude, int axis, double angle) -> Mat3 {
    return Eigen::AngleAxisd(angle, attitude.col(axis)).toRotationMatrix() * attitude;
  };
  for (auto _ : state) {
    for (std::size_t k = 0; k < rotations.size(); ++k) {
      const AttitudeAction& action = rotations.action(k);
      const Mat3 rolled = turn(from.attitude, 0, action.roll_rad);
      const Mat3 pitched = turn(rolled, 1, -action.pitch_rad);
      const Mat3 yawed = turn(pitched, 2, -action.yaw_rad);
      const Vec3 node = from.position + kStep * yawed.col(0);
      cost[k] = kFuel * (node - kGoal).norm();
      for (const NodeThreat& threat : spheres)
        cost[k] += threat.weight * std::max(0.0, threat.radius_m - (node - threat.center).norm());
    }
    benchmark::DoNotOptimize(cost.data());
    benchmark::ClobberMemory();
  }
  per_candidate(state, rotations.size());
}
BENCHMARK(literal);

}  // namespace
}  // namespace alate
