#include "aco/weights.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "space/simd.hpp"

namespace alate {

namespace {

constexpr std::size_t kLanes = 16;
constexpr float kNever = std::numeric_limits<float>::infinity();

const float* aligned(const AlignedFloats& array) {
  return static_cast<const float*>(__builtin_assume_aligned(array.data(), kSimdBytes));
}
float* aligned(AlignedFloats& array) { return static_cast<float*>(__builtin_assume_aligned(array.data(), kSimdBytes)); }
std::size_t whole(const AlignedFloats& array) { return array.size() & ~(kLanes - 1); }

/// exp(x) for x <= 0, to 3e-7 relative: 2^n times a polynomial (Taylor, degree 6) in the rest. No less than 1e-26. The
/// C library's expf does not vectorise, and differs between libraries.
inline float exp_of_negative(float x) {
  constexpr float kLog2e = std::numbers::log2e_v<float>;
  constexpr float kLn2 = std::numbers::ln2_v<float>;
  const float clamped = x > -60.0F ? x : -60.0F;
  const float turns = clamped * kLog2e;
  const int whole_turns = static_cast<int>(turns - 0.5F);
  const float r = (turns - static_cast<float>(whole_turns)) * kLn2;
  const float p = 1 + r * (1 + r * (0.5F + r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720))))));
  const auto power = std::bit_cast<float>((whole_turns + 127) << 23);
  return p * power;
}

using LaneSums = std::array<float, kLanes>;

ALATE_SIMD LaneSums sum_lanes(const AlignedFloats& weights) {
  const float* __restrict w = aligned(weights);
  const std::size_t count = whole(weights);
  alignas(kSimdBytes) LaneSums sums{};
  for (std::size_t row = 0; row < count; row += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += w[row + lane];
  return sums;
}

/// Least J + h. Bits of floats from 0 up are in order, and least whole numbers vectorise.
ALATE_SIMD float least_estimate(const Choices& choices) {
  const float* __restrict cost = aligned(choices.cost);
  const float* __restrict guide = aligned(choices.guide);
  const std::size_t count = whole(choices.cost);
  auto least = std::bit_cast<std::int32_t>(kNever);
  for (std::size_t k = 0; k < count; ++k) {
    const auto estimate = std::bit_cast<std::int32_t>(cost[k] + guide[k]);
    least = estimate < least ? estimate : least;
  }
  return std::bit_cast<float>(least);
}

}  // namespace

ALATE_SIMD void weigh_by_power(int beta, Choices& choices) {
  constexpr float kLeastCost = 1e-6F;  // the goal itself may cost nothing
  const float least = std::max(kLeastCost, *std::ranges::min_element(choices.cost));
  const float* __restrict cost = aligned(choices.cost);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  for (std::size_t k = 0; k < count; ++k) weight[k] = cost[k] < kNever ? 1.0F : 0.0F;
  for (int i = 0; i < beta; ++i)
    for (std::size_t k = 0; k < count; ++k) weight[k] *= least / (cost[k] > kLeastCost ? cost[k] : kLeastCost);
}

ALATE_SIMD void weigh_by_goal(float scale, Choices& choices) {
  const float least = least_estimate(choices);
  const float* __restrict cost = aligned(choices.cost);
  const float* __restrict guide = aligned(choices.guide);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  const float per_scale = -1 / scale;
  for (std::size_t k = 0; k < count; ++k) {
    const float above = cost[k] + guide[k] - least;
    // Where nothing is finite `above` is no number; the clamp makes one of it.
    weight[k] = exp_of_negative(above * per_scale) * (cost[k] + guide[k] < kNever ? 1.0F : 0.0F);
  }
}

ALATE_SIMD void multiply_by_trail(int alpha, Choices& choices) {
  const float* __restrict trail = aligned(choices.trail);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  for (int i = 0; i < alpha; ++i)
    for (std::size_t k = 0; k < count; ++k) weight[k] *= trail[k];
}

std::size_t draw(const AlignedFloats& weights, double uniform) {
  // Sums by lanes, as one running sum would not vectorise: the lane is drawn first, then the row.
  const LaneSums sums = sum_lanes(weights);
  float total = 0;
  for (const float sum : sums) total += sum;
  if (!(total > 0)) return weights.size();
  float left = static_cast<float>(uniform) * total;
  std::size_t lane = 0;
  for (; lane + 1 < kLanes && left >= sums[lane]; ++lane) left -= sums[lane];
  while (!(sums[lane] > 0)) --lane;
  std::size_t last = weights.size();
  for (std::size_t k = lane; k < weights.size(); k += kLanes) {
    if (!(weights[k] > 0)) continue;
    last = k;
    if (left < weights[k]) break;
    left -= weights[k];
  }
  return last;
}

std::size_t heaviest(const AlignedFloats& weights) {
  const auto found = std::ranges::max_element(weights);
  return found != weights.end() && *found > 0 ? static_cast<std::size_t>(found - weights.begin()) : weights.size();
}

}  // namespace alate
