// Moves between voxels, and which of them a shortest way may need.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "search/voxel/voxel_bits.hpp"
#include "search/voxel/voxel_cost.hpp"

namespace alate {

/// Sets of directions, and of blocked cells around one, by bits.
///
/// A step is free if every cell of the box that it spans is. Of all shortest ways between two places, jump point search
/// follows the one whose steps come first in the order corner, edge, face, and by number among these (Harabor and
/// Grastien 2011 take diagonal steps first; Nobes, Harabor, Wybrow and Walsh 2022 in three dimensions). Two steps of
/// it, d into a cell and e out of it, are never such that other free steps lead from before d to behind e in a shorter
/// way, or in one as short that comes first in that order; what may follow d is worked out from that, not from rules
/// for single cases. Nothing but the 26 cells around the one in the middle bears on it.
class VoxelMoves {
 public:
  using Set = std::uint32_t;

  static const VoxelMoves& table();

  static VoxelCost cost(unsigned direction) { return kCosts[kVoxelKinds[direction]]; }
  bool is_free(unsigned direction, Set blocked) const { return (boxes_[direction] & blocked) == 0; }
  /// All moves that are free.
  Set free(Set blocked) const {
    Set moves = 0;
    for (unsigned d = 0; d < kVoxelDirections; ++d)
      if (d != kNoVoxelDirection && is_free(d, blocked)) moves |= Set{1} << d;
    return moves;
  }
  /// The free moves that may follow a step `came` into the middle.
  Set successors(unsigned came, Set blocked) const {
    Set moves = 0;
    for (Set rest = candidates_[came]; rest != 0; rest &= rest - 1) {
      const auto next = static_cast<unsigned>(std::countr_zero(rest));
      if (is_free(next, blocked) && !is_needless(came, next, blocked)) moves |= Set{1} << next;
    }
    return moves;
  }
  /// The same where no cell around is blocked.
  Set natural(unsigned came) const { return natural_[came]; }

 private:
  static constexpr std::array<VoxelCost, 4> kCosts{0, kVoxelStraight, kVoxelDiagonal, kVoxelTriple};

  VoxelMoves();
  void note_pair(unsigned came, unsigned next);
  bool is_needless(unsigned came, unsigned next, Set blocked) const {
    const auto [first, last] = ways_round_[came * kVoxelDirections + next];
    for (std::uint32_t i = first; i < last; ++i)
      if ((ways_[i] & blocked) == 0) return true;
    return false;
  }

  std::array<Set, kVoxelDirections> boxes_{};
  std::array<Set, kVoxelDirections> candidates_{};
  std::array<Set, kVoxelDirections> natural_{};
  std::vector<Set> ways_;  ///< Cells that must be free for another way to be.
  std::array<std::array<std::uint32_t, 2>, std::size_t{kVoxelDirections} * kVoxelDirections> ways_round_{};
};

}  // namespace alate
