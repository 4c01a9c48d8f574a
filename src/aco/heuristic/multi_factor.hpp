// The multi-factor heuristic of Li et al. 2019 and the adaptive one of Yin et al. 2021, eqs. (1)-(6), (12).
//
// [C]: as in the public program for Li et al. 2019; [A-prose]: in words in Yin et al. 2021, whose formulas were not
// available; [R]: reconstructed. Which cells an ant has visited changes n_i and the ranges of goal distances and
// heights among its feasible neighbours J_i, so weights are worked out at every step, eight side by side.
#pragma once

#include <array>

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
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
  using Row = std::array<float, MoveCells::kRow>;

  MultiFactor(const GridSpace& space, const MultiFactorRule& rule);

  /// tau^alpha, where trails have changed since the last time.
  void prepare(const Trail<MoveCells>& trail);

  /// Eq. (6), by roulette [C]; kNoDirection where J_i is empty.
  unsigned operator()(const GridStand& at, Stream& stream) const;

  /// J_i, bit d for direction d: free and not visited [C].
  unsigned feasible(const GridStand& at) const { return space_.open(at.cell) & ~at.tabu; }
  /// Eq. (12) for the members of J_i; the rest means nothing.
  Row eta(const GridStand& at, unsigned feasible) const;
  /// Numerators of eq. (6), 0 outside J_i.
  Row weights(const GridStand& at, unsigned feasible) const;

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;

  void note_neighbours();
  void note_trails(GridSpace::Cell cell, const Trail<MoveCells>& trail);
  // Inlined into the step, which is compiled for several processors.
  Row safety(unsigned came, unsigned feasible) const;
  Row join_factors(const GridStand& at, unsigned feasible) const;
  Row numerators(const GridStand& at, unsigned feasible) const;

  const GridSpace& space_;
  MultiFactorRule rule_;
  Row step_factor_{};
  AlignedFloats to_goal_, descent_, mu_, tau_;  ///< Rows of eight by cell: d_jE, h(i)-h(j), mu^power, tau^alpha.
  bool prepared_ = false;
};

}  // namespace alate
