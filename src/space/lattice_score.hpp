// What a route over a terrain lattice costs, in tables: by the scenario's objective, or as Mai et al. 2023 judge it.
#pragma once

#include <array>
#include <vector>

#include "space/choices.hpp"
#include "space/lattice_moves.hpp"
#include "space/objective.hpp"

namespace alate {

/// Eq. (20): F = length * C_0 + height * C_h + turn * C_theta with eqs. (21)-(23), verbatim; km, km and radians.
/// Weights, units and the heights' datum are ours: none was readable. Heights are those of the legs' ends; in the legs'
/// middles the sum differs by half the difference between start and goal, the same for all routes. theta_1, which has
/// no leg before it, is 0.
struct TerrainScore {
  enum class Rule { objective, paper };
  enum class Datum { sea, ground };

  Rule rule = Rule::objective;
  double length = 1;
  double height = 1;
  double turn = 1;
  Datum datum = Datum::sea;
  bool degrees = false;
  double penalty = 0;  ///< Of each broken constraint, where they do not filter.

  bool is_papers() const { return rule == Rule::paper; }
};

/// Immutable once made.
class LatticeScore {
 public:
  using Node = LatticeFrame::Node;

  /// `frame` and `moves` must outlive this.
  LatticeScore(const World& world, const LatticeFrame& frame, const LatticeMoves& moves, const TerrainScore& rule);

  const TerrainScore& rule() const { return rule_; }

  /// Of a move and the node it leads to.
  double of_move(Node node, unsigned move) const { return of_step(node, LatticeFrame::kFirst, move); }
  /// Of a move after another one, the turn between them included.
  double of_step(Node node, unsigned came, unsigned move) const { return of_step_[came][move] + of_place(node, move); }
  /// Of the last leg, which follows `came`.
  double of_join(Node node, unsigned came) const;

  /// Does a move's cost depend on the move before it?
  bool minds_turns() const { return rule_.is_papers() && rule_.turn != 0; }
  /// No leg's end adds less; 0 or below, as ground may lie below the sea.
  double least_of_end() const { return least_of_end_; }

  /// Straight to the goal, were the air free; 0 or more, and never above what a route costs by the objective.
  double of_straight(const Vec3& from) const { return of_length(frame_.goal() - from); }

  double length_m(unsigned move) const { return length_m_[move]; }
  double join_length_m(Node node) const { return (frame_.goal() - frame_.position(node)).norm(); }

 private:
  static constexpr std::size_t kRow = 32;

  double of_length(const Vec3& leg) const;
  double of_angle(const Vec3& before, const Vec3& after) const;
  double of_place(Node node, unsigned move) const {
    return (of_height_.empty() ? 0 : double{of_height_[frame_.after(node, move)]}) +
           (exposed_.empty() ? 0 : double{exposed_[kRow * node + move]});
  }
  void note_heights();
  void note_exposures(const World& world, const LatticeMoves& moves);
  void note_joins(const World& world, const LatticeMoves& moves);

  const LatticeFrame& frame_;
  TerrainScore rule_;
  ObjectiveSpec objective_;
  std::array<double, LatticeFrame::kMostMoves> length_m_{};
  std::array<std::array<double, LatticeFrame::kMostMoves>, LatticeFrame::kMostMoves + 1>
      of_step_{};  ///< By shape alone.
  double least_of_end_ = 0;
  std::vector<float> of_height_;  ///< By node; empty where heights do not count.
  AlignedFloats exposed_;         ///< By node and move; empty without threats.
  std::vector<double> of_join_;   ///< Without its turn, by node of the last plane.
};

}  // namespace alate
