#include "aco/heuristic/multi_factor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "space/simd.hpp"

namespace alate {

namespace {

constexpr std::size_t kRow = MoveCells::kRow;
using Row = MultiFactor::Row;

/// 0.001 under eqs. (1) and (3): no division by 0 where all neighbours are alike [C].
constexpr float kNoZero = 0.001F;
constexpr float kNever = std::numeric_limits<float>::infinity();

float power(float base, int exponent) {
  float result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

struct Extremes {
  float least = kNever;
  float most = -kNever;
};

/// Of the values whose bit is set, by halves: one running minimum would be waited for eight times.
[[gnu::always_inline]] inline Extremes extremes(const Row& values, unsigned members) {
  Row low;
  Row high;
  for (std::size_t d = 0; d < kRow; ++d) {
    const bool is_member = ((members >> d) & 1U) != 0;
    low[d] = is_member ? values[d] : kNever;
    high[d] = is_member ? values[d] : -kNever;
  }
  for (const std::size_t half : {4U, 2U, 1U}) {
    for (std::size_t d = 0; d < half; ++d) {
      low[d] = low[d + half] < low[d] ? low[d + half] : low[d];
      high[d] = high[d + half] > high[d] ? high[d + half] : high[d];
    }
  }
  return {.least = low[0], .most = high[0]};
}

[[gnu::always_inline]] inline Row row_of(const AlignedFloats& table, GridSpace::Cell cell) {
  Row row;
  std::copy_n(&table[kRow * cell], kRow, row.begin());
  return row;
}

}  // namespace

MultiFactor::MultiFactor(const GridSpace& space, const MultiFactorRule& rule) : space_(space), rule_(rule) {
  for (unsigned d = 0; d < kRow; ++d) step_factor_[d] = rule.step_factor ? static_cast<float>(1 / space.step(d)) : 0;
  if (rule.join == MultiFactorRule::Join::product && !rule.step_factor) step_factor_.fill(1);
  for (AlignedFloats* table : {&to_goal_, &descent_, &mu_, &tau_}) table->resize(kRow * space.cells());
  note_neighbours();
}

void MultiFactor::note_neighbours() {
  constexpr double kLeast = 1e-3;  // a = 0 or b = 0 at the very end
  const int exponent = rule_.mu_power * (rule_.mu_place == MultiFactorRule::MuPlace::inside ? rule_.beta : 1);
  for (GridSpace::Cell cell = 0; cell < space_.cells(); ++cell) {
    for (unsigned d = 0; d < kRow; ++d) {
      if (((space_.open(cell) >> d) & 1U) == 0) continue;
      const GridSpace::Cell to = space_.neighbour(cell, d);
      to_goal_[kRow * cell + d] = space_.to_goal(to);
      descent_[kRow * cell + d] = space_.height(cell) - space_.height(to);
      const double sum = rule_.a * double{space_.from_start(to)} + rule_.b * double{space_.to_goal(to)};
      mu_[kRow * cell + d] = power(static_cast<float>(1 / std::max(sum, kLeast)), exponent);  // eq. (5)
    }
  }
}

void MultiFactor::prepare(const Trail<MoveCells>& trail) {
  if (!prepared_)
    for (GridSpace::Cell cell = 0; cell < space_.cells(); ++cell) note_trails(cell, trail);
  else
    for (const GridSpace::Cell cell : trail.store().known_cells()) note_trails(cell, trail);
  prepared_ = true;
}

void MultiFactor::note_trails(GridSpace::Cell cell, const Trail<MoveCells>& trail) {
  const StoredTrail* stored = trail.store().row(cell);
  for (std::size_t d = 0; d < kRow; ++d)
    tau_[kRow * cell + d] = power(trail.levels().read(stored[d]), rule_.alpha) * mu_[kRow * cell + d];
}

/// Eq. (2): r_ij [C], weights theta and 1 - theta [R].
[[gnu::always_inline]] inline Row MultiFactor::safety(unsigned came, unsigned feasible) const {
  const auto count = static_cast<float>(std::popcount(feasible));
  const auto u = static_cast<float>(rule_.u);
  const auto theta = static_cast<float>(rule_.theta);
  const bool first = came == GridSpace::kNoDirection;
  const bool shared = first && rule_.first_move == MultiFactorRule::FirstMove::shared;
  Row r;
  r.fill(shared ? u / count : first ? theta * u : (1 - theta) * u / count);
  if (!first) r[came] = theta * u;
  return r;
}

[[gnu::always_inline]] inline Row MultiFactor::join_factors(const GridStand& at, unsigned feasible) const {
  const auto omega = static_cast<float>(rule_.omega);
  const auto mu0 = static_cast<float>(rule_.mu0);
  const Row to_goal = row_of(to_goal_, at.cell);
  const Row descent = row_of(descent_, at.cell);
  Row steepness;
  for (std::size_t d = 0; d < kRow; ++d) steepness[d] = std::fabs(descent[d]);
  const bool is_signed = rule_.range == MultiFactorRule::Range::signed_heights;
  const Extremes far = extremes(to_goal, feasible);
  const Extremes steep = extremes(steepness, feasible);
  const Extremes range = is_signed ? extremes(descent, feasible) : steep;
  const float per_far = omega / (far.most - far.least + kNoZero);
  const float per_range = omega / (range.most - range.least + kNoZero);
  const Row r = safety(at.came, feasible);
  Row eta;
  for (std::size_t d = 0; d < kRow; ++d) {
    const float phi = per_far * (far.most - to_goal[d]) + mu0;      // eq. (1)
    const float v = per_range * (steep.most - steepness[d]) + mu0;  // eqs. (3), (4)
    eta[d] = rule_.join == MultiFactorRule::Join::sum ? r[d] + step_factor_[d] + phi + v
                                                      : r[d] * step_factor_[d] * phi * v;  // eq. (12)
  }
  return eta;
}

[[gnu::always_inline]] inline Row MultiFactor::numerators(const GridStand& at, unsigned feasible) const {
  Row weights = row_of(tau_, at.cell);
  const Row base = join_factors(at, feasible);
  for (int i = 0; i < rule_.beta; ++i)
    for (std::size_t d = 0; d < kRow; ++d) weights[d] *= base[d];
  for (std::size_t d = 0; d < kRow; ++d) weights[d] = ((feasible >> d) & 1U) != 0 ? weights[d] : 0;
  return weights;
}

Row MultiFactor::eta(const GridStand& at, unsigned feasible) const { return join_factors(at, feasible); }

Row MultiFactor::weights(const GridStand& at, unsigned feasible) const { return numerators(at, feasible); }

ALATE_SIMD unsigned MultiFactor::operator()(const GridStand& at, Stream& stream) const {
  const unsigned members = feasible(at);
  if (members == 0) return GridSpace::kNoDirection;
  Row until = numerators(at, members);
  for (std::size_t d = 1; d < kRow; ++d) until[d] += until[d - 1];
  const auto uniform = static_cast<float>(stream.uniform()) * until.back();
  unsigned direction = 0;
  for (const float sum : until) direction += sum <= uniform ? 1 : 0;
  return std::min(direction, static_cast<unsigned>(std::bit_width(members)) - 1);
}

}  // namespace alate
