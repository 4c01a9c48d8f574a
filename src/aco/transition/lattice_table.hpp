// Moves of a terrain lattice drawn from a table: for each node the weights tau^alpha eta^beta of its moves, built again
// where trails have changed.
//
// Source: Mai et al. 2023, eq. (7), verbatim, and (14), reconstructed: the pseudo-random proportional rule of Dorigo,
// Gambardella 1997. Turn limits are a mask by the last move. Ants that take the best and ants that draw are told apart
// before either choose; a draw sums 28 weights in four lanes, draws the lane and then the row: no branch depends on
// chance.
#pragma once

#include <array>

#include "aco/pheromone/lattice_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/q0_schedule.hpp"
#include "aco/walk/lattice_stands.hpp"

namespace alate {

struct LatticeTableRule {
  int alpha = 1;
  Q0Schedule q0;
  bool bounded = false;  ///< Trails evaporate everywhere and meet bounds: shares change without a deposit.
};

class LatticeTable {
 public:
  using Node = TerrainLattice::Node;

  /// `heuristic`: eta^beta in rows of kRow by node; 0 where a move is not open. `lattice` must outlive this.
  LatticeTable(const TerrainLattice& lattice, AlignedFloats heuristic, const LatticeTableRule& rule);

  /// Before iteration `n` (from 0) of `most`.
  void prepare(Trail<LatticeCells>& trail, std::uint64_t n, std::uint64_t most);

  /// Asks memory for the weights of a node, for when an ant will choose there.
  void fetch(Node node) const {
    __builtin_prefetch(&weights_[kRow * node]);
    __builtin_prefetch(&weights_[kRow * node + kRow / 2]);
  }

  /// LatticeStands::kNoMove where no candidate is left.
  void choose(const LatticeStands& ants, LatticeStands::Moves& moves) const;

 private:
  static constexpr std::size_t kRow = TerrainLattice::kRow;
  static constexpr std::size_t kQuads = LatticeStands::kNoMove / 4;
  using Quad = float __attribute__((vector_size(16)));
  using QuadMask = std::int32_t __attribute__((vector_size(16)));

  /// Four weights from move `from` on, 0 where a move may not follow.
  Quad weights(Node node, unsigned came, std::size_t from) const;
  unsigned draw(Node node, unsigned came, float uniform) const;
  unsigned heaviest(Node node, unsigned came) const;
  void rebuild(Node node, const Trail<LatticeCells>& trail);

  const TerrainLattice& lattice_;
  AlignedFloats heuristic_, weights_;
  std::array<std::array<std::int32_t, kRow>, TerrainLattice::kFirst + 1> may_{};  ///< By the last move: a mask.
  LatticeTableRule rule_;
  float q0_ = 0;
};

}  // namespace alate
