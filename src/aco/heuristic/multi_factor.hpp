// The multi-factor heuristic of Li et al. 2019 and the adaptive one of Yin et al. 2021, eqs. (1)-(6), (12).
//
// [C]: as in the public program for Li et al. 2019; [A-prose]: in words in Yin et al. 2021, whose formulas were not
// available; [R]: reconstructed. Which cells an ant has visited changes n_i and the ranges of goal distances and
// heights among its feasible neighbours J_i, so weights are worked out at every step, eight side by side.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/octet.hpp"
#include "aco/walk/grid_walk.hpp"

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
  unsigned operator()(const GridStand& at, Stream& stream) const {
    const unsigned members = feasible(at);
    if (members == 0) return GridSpace::kNoDirection;
    const unsigned direction = draw(weights(at, members), stream.uniform_float());
    return std::min(direction, static_cast<unsigned>(std::bit_width(members)) - 1);
  }

  /// J_i, bit d for direction d: free and not visited [C].
  unsigned feasible(const GridStand& at) const { return space_.open(at.cell) & ~at.tabu; }
  /// Eq. (12) for the members of J_i; the rest means nothing.
  Octet eta(const GridStand& at, unsigned feasible) const;
  /// Numerators of eq. (6), 0 outside J_i.
  Octet weights(const GridStand& at, unsigned feasible) const;

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;
  /// 0.001 under eqs. (1) and (3): no division by 0 where all neighbours are alike [C].
  static constexpr float kNoZero = 0.001F;

  /// n_i; not every x86-64 can count bits.
  static constexpr std::array<std::uint8_t, 256> counts() {
    std::array<std::uint8_t, 256> counts{};
    for (unsigned members = 0; members < counts.size(); ++members)
      counts[members] = static_cast<std::uint8_t>(std::popcount(members));
    return counts;
  }
  static const std::array<std::uint8_t, 256> kCount;

  void note_safety();
  void note_neighbours();
  void note_trails(GridSpace::Cell cell, const Trail<MoveCells>& trail);

  const GridSpace& space_;
  MultiFactorRule rule_;
  float omega_, mu0_;
  /// What of eq. (12) no place changes, by the direction one came in and n_i: eq. (2) joined with 1/d(i,j).
  std::array<std::array<std::array<float, kRow>, kRow + 1>, kRow + 1> base_{};
  /// Rows of eight by cell: d_jE, h(i)-h(j) or |h(i)-h(j)| as eq. (3) needs it, mu^power, tau^alpha mu^power.
  AlignedFloats to_goal_, descent_, mu_, tau_;
  bool prepared_ = false;
};

inline constexpr std::array<std::uint8_t, 256> MultiFactor::kCount = MultiFactor::counts();

/// Of the members of J_i: the largest d_jE, -d_jE, h and -h, where h is what descent_ has; J_i is not empty.
inline Octet::Quad extremes(const Octet& to_goal, const Octet& descent, const OctetMask& members) {
  using Quad = Octet::Quad;
  const Octet out = members.others().keep(Octet::all(-std::numeric_limits<float>::infinity()));
  const auto halves = [](const Octet& values) { return larger(values.low, values.high); };
  const Quad far = halves(out + to_goal);
  const Quad near = halves(out - to_goal);
  const Quad down = halves(out + descent);
  const Quad up = halves(out - descent);
  const auto join = [](const Quad& a, const Quad& b) {  // a, b, a, b
    return larger(__builtin_shufflevector(a, b, 0, 4, 1, 5), __builtin_shufflevector(a, b, 2, 6, 3, 7));
  };
  const Quad goal = join(far, near);
  const Quad height = join(down, up);
  return larger(__builtin_shufflevector(goal, height, 0, 1, 4, 5), __builtin_shufflevector(goal, height, 2, 3, 6, 7));
}

inline Octet MultiFactor::eta(const GridStand& at, unsigned feasible) const {
  using Quad = Octet::Quad;
  const Octet to_goal = Octet::load(&to_goal_[kRow * at.cell]);
  const Octet descent = Octet::load(&descent_[kRow * at.cell]);
  const Octet base = Octet::load(base_[at.came][kCount[feasible]].data());
  const Quad most = extremes(to_goal, descent, OctetMask::of(feasible));
  const Quad range = most + __builtin_shufflevector(most, most, 1, 0, 3, 2) + kNoZero;
  const Quad per = omega_ / range;
  const Quad steepest = larger(most, __builtin_shufflevector(most, most, 1, 0, 3, 2));
  const Octet phi = Octet::all(per[0]) * (Octet::all(most[0]) - to_goal);              // eq. (1), less mu0
  const Octet v = Octet::all(per[2]) * (Octet::all(steepest[2]) - absolute(descent));  // eqs. (3), (4), less mu0
  if (rule_.join == MultiFactorRule::Join::sum) return base + phi + v;                 // eq. (12)
  return base * (phi + Octet::all(mu0_)) * (v + Octet::all(mu0_));
}

inline Octet MultiFactor::weights(const GridStand& at, unsigned feasible) const {
  Octet weights = OctetMask::of(feasible).keep(Octet::load(&tau_[kRow * at.cell]));
  const Octet base = eta(at, feasible);
  for (int i = 0; i < rule_.beta; ++i) weights = weights * base;
  return weights;
}

}  // namespace alate
