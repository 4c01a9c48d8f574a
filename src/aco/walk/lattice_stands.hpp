// Ants on a terrain lattice, all in one plane, as a choice of moves sees them.
#pragma once

#include <array>
#include <cstdint>

#include "space/terrain_lattice.hpp"

namespace alate {

/// Ants that are about to choose, side by side.
struct LatticeStands {
  static constexpr std::size_t kMost = 16;
  static constexpr unsigned kNoMove = 28;  ///< Behind 25 moves, filled up to whole lanes.
  using Moves = std::array<unsigned, kMost>;

  std::size_t count = 0;
  std::array<TerrainLattice::Node, kMost> node{};
  std::array<unsigned, kMost> came{};       ///< Last moves.
  std::array<std::uint64_t, kMost> bits{};  ///< A random number each.

  /// The last ant takes the place of one that is gone.
  void remove(std::size_t at) {
    --count;
    node[at] = node[count];
    came[at] = came[count];
  }
};

}  // namespace alate
