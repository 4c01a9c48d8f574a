#include "aco/heuristic/multi_factor.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {
template <class Base>
Base power(const Base& base, int exponent) {
  Base result = Base{} + 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

}  // namespace

MultiFactor::MultiFactor(const GridSpace& space, const MultiFactorRule& rule)
    : space_(space), rule_(rule), omega_(static_cast<float>(rule.omega)), mu0_(static_cast<float>(rule.mu0)) {
  for (AlignedFloats* table : {&to_goal_, &descent_, &mu_, &tau_}) table->resize(kRow * space.cells());
  note_safety();
  note_neighbours();
}

/// Eq. (2): r_ij [C], weights theta and 1 - theta [R]. `count`: n_i.
double MultiFactor::safety(unsigned came, unsigned count, unsigned direction) const {
  const bool first = came == GridSpace::kNoDirection;
  if (first && rule_.first_move == MultiFactorRule::FirstMove::shared) return rule_.u / count;
  return first || direction == came ? rule_.theta * rule_.u : (1 - rule_.theta) * rule_.u / count;
}

/// With 1/d, the other factor of eq. (12) that does not depend on the place.
void MultiFactor::note_safety() {
  const bool is_sum = rule_.join == MultiFactorRule::Join::sum;
  for (unsigned d = 0; d < kRow; ++d) {
    const double neutral = is_sum ? 0 : 1;
    const double step = rule_.step_factor ? 1 / space_.step(d) : neutral;
    for (unsigned came = 0; came <= kRow; ++came)
      for (unsigned count = 1; count <= kRow; ++count) {
        const double r = safety(came, count, d);
        safety_[came][count][d] = static_cast<float>(is_sum ? r + step : r * step);
      }
  }
}

void MultiFactor::note_neighbours() {
  constexpr double kLeast = 1e-3;  // a = 0 or b = 0 at the very end
  const int exponent = rule_.mu_power * (rule_.mu_place == MultiFactorRule::MuPlace::inside ? rule_.beta : 1);
  const bool is_signed = rule_.range == MultiFactorRule::Range::signed_heights;
  for (GridSpace::Cell cell = 0; cell < space_.cells(); ++cell) {
    for (unsigned d = 0; d < kRow; ++d) {
      if (((space_.open(cell) >> d) & 1U) == 0) continue;
      const GridSpace::Cell to = space_.neighbour(cell, d);
      to_goal_[kRow * cell + d] = space_.to_goal(to);
      const float descent = space_.height(cell) - space_.height(to);
      descent_[kRow * cell + d] = is_signed ? descent : std::fabs(descent);
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
  for (const std::size_t half : {0U, 4U}) {
    const std::size_t at = kRow * cell + half;
    const LaneFloats level = trail.levels().read(load_four(trail.store().row(cell) + half));
    const LaneFloats tau = power(level, rule_.alpha) * load_four(&mu_[at]);
    std::memcpy(&tau_[at], &tau, sizeof tau);
  }
}

}  // namespace alate
