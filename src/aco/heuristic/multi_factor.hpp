// The multi-factor heuristic of Li et al. 2019 and the adaptive one of Yin et al. 2021, eqs. (1)-(6), (12).
//
// [C]: as in the public program for Li et al. 2019; [A-prose]: in words in Yin et al. 2021, whose formulas were not
// available; [R]: reconstructed. Which cells an ant has visited changes n_i and the ranges of goal distances and
// heights among its feasible neighbours J_i, so weights are worked out at every step, for four ants side by side.
#pragma once

#include <array>
#include <bit>
#include <limits>

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/lanes.hpp"

namespace alate {

/// Every choice where source and paper leave one. Defaults are Li et al. 2019 as coded.
struct MultiFactorRule {
  /// Height differences that make the range under eq. (3): as coded, signed ones; or, as the prose of Yin et al. may
  /// mean, absolute ones as above the line.
  enum class Range { signed_heights, absolute_heights };
  enum class Join { sum, product };
  /// r of the first move: u / n_i as coded, or that of a straight one.
  enum class FirstMove { shared, straight };
  /// Eq. (6) [R]: mu beside eta^beta, or inside the power, (eta mu)^beta.
  enum class MuPlace { beside, inside };

  int alpha = 1;
  int beta = 3;
  double omega = 10;   ///< Eqs. (1), (3).
  double mu0 = 1;      ///< Eqs. (1), (3); not mu_ij.
  double u = 10;       ///< Eq. (2).
  double theta = 0.5;  ///< Eq. (2); source C has 0.5 in both places.
  FirstMove first_move = FirstMove::shared;
  Range range = Range::signed_heights;
  Join join = Join::sum;    ///< Eq. (12).
  bool step_factor = true;  ///< 1/d(i,j) in eq. (12).
  int mu_power = 0;         ///< Eq. (6): 0 in Li et al. 2019, 1 in Yin et al. 2021 [R].
  MuPlace mu_place = MuPlace::beside;
  double a = 1;  ///< Eq. (5) [R]: only a : b matters.
  double b = 1;
};

class MultiFactor {
 public:
  MultiFactor(const GridSpace& space, const MultiFactorRule& rule);

  /// tau^alpha, where trails have changed since the last time.
  void prepare(const Trail<MoveCells>& trail);

  /// Eq. (6), by roulette [C]; kNoDirection where J_i is empty.
  [[gnu::always_inline]] LaneBits operator()(const GridStands& at, const LaneStreams& streams) const {
    return pick(weights(at), draw_uniform(streams));
  }

  /// Eq. (12) for the members of J_i; the rest means nothing.
  MoveLanes eta(const GridStands& at) const { return eta(at, feasible(at)); }
  /// Numerators of eq. (6), 0 outside J_i.
  MoveLanes weights(const GridStands& at) const;

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;
  /// 0.001 under eqs. (1) and (3): no division by 0 where all neighbours are alike [C].
  static constexpr float kNoZero = 0.001F;

  /// By direction: is it in J_i, free and not visited [C]?
  using Members = std::array<LaneBits, kRow>;
  /// The least and the largest of some values of the members of J_i.
  struct Range {
    LaneFloats least, most;
  };

  Members feasible(const GridStands& at) const;
  static Range range(const MoveLanes& values, const Members& members);
  double safety(unsigned came, unsigned count, unsigned direction) const;
  MoveLanes safety(const GridStands& at, const Members& members) const;
  MoveLanes eta(const GridStands& at, const Members& members) const;

  void note_safety();
  void note_neighbours();
  void note_trails(GridSpace::Cell cell, const Trail<MoveCells>& trail);

  const GridSpace& space_;
  MultiFactorRule rule_;
  float omega_, mu0_;
  /// Eq. (2) joined with 1/d(i,j), by the direction one came in and n_i.
  std::array<std::array<std::array<float, kRow>, kRow + 1>, kRow + 1> safety_{};
  /// Rows of eight by cell: d_jE, h(i)-h(j) or |h(i)-h(j)| as eq. (3) needs it, mu^power, tau^alpha mu^power.
  AlignedFloats to_goal_, descent_, mu_, tau_;
  bool prepared_ = false;
};

[[gnu::always_inline]] inline MultiFactor::Members MultiFactor::feasible(const GridStands& at) const {
  const auto moves = [&](std::size_t i) { return static_cast<std::int32_t>(space_.open(at.cell[i])); };
  const LaneBits open{moves(0), moves(1), moves(2), moves(3)};
  Members members;
  for (unsigned d = 0; d < kRow; ++d) members[d] = at.left(d) & ((open & (1 << d)) != 0);
  return members;
}

/// With all bits set a value is no number, and no comparison with it holds.
[[gnu::always_inline]] inline MultiFactor::Range MultiFactor::range(const MoveLanes& values, const Members& members) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  Range range{.least = LaneFloats{} + kNever, .most = LaneFloats{} - kNever};
  for (std::size_t d = 0; d < kRow; ++d) {
    const auto value = std::bit_cast<LaneFloats>(std::bit_cast<LaneBits>(values[d]) | ~members[d]);
    range.least = smaller(value, range.least);
    range.most = larger(value, range.most);
  }
  return range;
}

[[gnu::always_inline]] inline MoveLanes MultiFactor::safety(const GridStands& at, const Members& members) const {
  LaneBits count{};
  for (const LaneBits& member : members) count -= member;
  std::array<const float*, kAntLanes> rows{};
  for (std::size_t i = 0; i < kAntLanes; ++i) rows[i] = safety_[at.came[i]][static_cast<std::size_t>(count[i])].data();
  return load_rows(rows);
}

[[gnu::always_inline]] inline MoveLanes MultiFactor::eta(const GridStands& at, const Members& members) const {
  const MoveLanes to_goal = at.load(to_goal_);
  const MoveLanes descent = at.load(descent_);
  const Range far = range(to_goal, members);
  const Range height = range(descent, members);
  const LaneFloats per_far = omega_ / (far.most - far.least + kNoZero);
  const LaneFloats per_height = omega_ / (height.most - height.least + kNoZero);
  const LaneFloats steepest = larger(height.most, -height.least);
  MoveLanes eta = safety(at, members);
  for (std::size_t d = 0; d < kRow; ++d) {
    const LaneFloats phi = per_far * (far.most - to_goal[d]) + mu0_;                          // eq. (1)
    const LaneFloats v = per_height * (steepest - larger(descent[d], -descent[d])) + mu0_;    // eqs. (3), (4)
    eta[d] = rule_.join == MultiFactorRule::Join::sum ? eta[d] + phi + v : eta[d] * phi * v;  // eq. (12)
  }
  return eta;
}

[[gnu::always_inline]] inline MoveLanes MultiFactor::weights(const GridStands& at) const {
  const Members members = feasible(at);
  const MoveLanes base = eta(at, members);
  MoveLanes weights = at.load(tau_);
  for (int i = 0; i < rule_.beta; ++i)
    for (std::size_t d = 0; d < kRow; ++d) weights[d] *= base[d];
  for (std::size_t d = 0; d < kRow; ++d) weights[d] = keep(weights[d], members[d]);
  return weights;
}

}  // namespace alate
