#include "aco/weights.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "space/simd.hpp"

namespace alate {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

using Lanes = std::array<float, kLanes>;

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

/// Least of values from 0 up. Their bits are in order, and least whole numbers vectorise.
template <class Value>
[[gnu::always_inline]] inline float least_of(std::size_t count, const Value& value) {
  auto least = std::bit_cast<std::int32_t>(kNever);
  for (std::size_t k = 0; k < count; ++k) {
    const auto one = std::bit_cast<std::int32_t>(value(k));
    least = one < least ? one : least;
  }
  return std::bit_cast<float>(least);
}

/// Sums by lanes, as one running sum would not vectorise.
inline Lanes sum_lanes(std::size_t count, const float* weights) {
  alignas(kSimdBytes) Lanes sums{};
  for (std::size_t row = 0; row < count; row += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += weights[row + lane];
  return sums;
}

/// Running sums, in four runs side by side: one chain of 16 additions would be waited for.
inline Lanes running(Lanes sums) {
  constexpr std::size_t kRun = 4;
  for (std::size_t i = 1; i < kRun; ++i)
    for (std::size_t first = 0; first < kLanes; first += kRun) sums[first + i] += sums[first + i - 1];
  for (std::size_t first = kRun; first < kLanes; first += kRun)
    for (std::size_t i = 0; i < kRun; ++i) sums[first + i] += sums[first - 1];
  return sums;
}

}  // namespace

ALATE_SIMD void weigh_by_power(int beta, Choices& choices) {
  constexpr float kLeastCost = 1e-6F;  // the goal itself may cost nothing
  const float* __restrict cost = aligned(choices.cost);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  const float found = least_of(count, [cost](std::size_t k) { return cost[k]; });
  const float least = found > kLeastCost ? found : kLeastCost;
  for (std::size_t row = 0; row < count; row += kLanes) {
    alignas(kSimdBytes) Lanes ratio;
    alignas(kSimdBytes) Lanes product;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float one = cost[row + i];
      ratio[i] = least / (one > kLeastCost ? one : kLeastCost);
      product[i] = one < kNever ? 1.0F : 0.0F;
    }
    for (int power = 0; power < beta; ++power)
      for (std::size_t i = 0; i < kLanes; ++i) product[i] *= ratio[i];
    for (std::size_t i = 0; i < kLanes; ++i) weight[row + i] = product[i];
  }
}

ALATE_SIMD void weigh_by_goal(float scale, Choices& choices) {
  const float* __restrict cost = aligned(choices.cost);
  const float* __restrict guide = aligned(choices.guide);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  const float least = least_of(count, [=](std::size_t k) { return cost[k] + guide[k]; });
  const float per_scale = -1 / scale;
  for (std::size_t k = 0; k < count; ++k) {
    const float estimate = cost[k] + guide[k];
    // Where nothing is finite this is no number; the clamp makes one of it.
    const float exponent = (estimate - least) * per_scale;
    weight[k] = exp_of_negative(exponent) * (estimate < kNever ? 1.0F : 0.0F);
  }
}

ALATE_SIMD void multiply_by_trail(const TrailLevels& levels, int alpha, Choices& choices) {
  float* __restrict trail = aligned(choices.trail);
  float* __restrict weight = aligned(choices.weight);
  const std::size_t count = whole(choices.weight);
  const TrailLevels rule = levels;  // a copy cannot be changed by what is written
  for (std::size_t k = 0; k < count; ++k) {
    trail[k] = rule.read(trail[k]);
    weight[k] *= trail[k];
  }
  for (int i = 1; i < alpha; ++i)
    for (std::size_t k = 0; k < count; ++k) weight[k] *= trail[k];
}

/// The lane is drawn first, then the row. Without branches that depend on chance: each would cost as much as ten sums.
ALATE_SIMD std::size_t draw(const AlignedFloats& weights, double uniform) {
  const float* __restrict weight = aligned(weights);
  const std::size_t count = whole(weights);
  const Lanes sums = sum_lanes(count, weight);
  const Lanes until = running(sums);
  const float total = until.back();
  if (!(total > 0)) return count;
  float left = static_cast<float>(uniform) * total;
  std::size_t lane = 0;
  for (const float sum : until) lane += sum <= left ? 1U : 0U;
  if (lane == kLanes) --lane;  // rounded up
  while (!(sums[lane] > 0)) --lane;
  left -= lane > 0 ? until[lane - 1] : 0;
  float sum = 0;
  std::size_t drawn = lane;
  std::size_t last = lane;
  for (std::size_t k = lane; k < count; k += kLanes) {
    sum += weight[k];
    drawn += sum <= left ? kLanes : 0;
    last = weight[k] > 0 ? k : last;
  }
  return drawn < last ? drawn : last;
}

std::size_t heaviest(const AlignedFloats& weights) {
  const auto found = std::ranges::max_element(weights);
  return found != weights.end() && *found > 0 ? static_cast<std::size_t>(found - weights.begin()) : weights.size();
}

}  // namespace alate
