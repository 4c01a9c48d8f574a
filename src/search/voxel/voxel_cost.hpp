// Lengths of ways on a grid of cubes, exact in whole numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <numbers>

namespace alate {

/// How many steps of each kind a way has: across a face, an edge, a corner.
struct VoxelLength {
  std::int64_t straights = 0;
  std::int64_t diagonals = 0;
  std::int64_t triples = 0;

  /// In cell sides.
  double value() const {
    return static_cast<double>(straights) + static_cast<double>(diagonals) * std::numbers::sqrt2 +
           static_cast<double>(triples) * std::numbers::sqrt3;
  }
  bool operator==(const VoxelLength&) const = default;
};

/// A whole number that orders lengths a + b sqrt(2) + c sqrt(3) as they are, equal ones only if all three counts are.
///
/// With these costs of steps, sqrt(2) and sqrt(3) times that of a straight one are off by less than 3.2e-6 and 4.7e-6
/// units, so that a length of up to 97 000 steps of a kind is off by less than one unit: two lengths could change their
/// order only if their costs were equal. No whole numbers a, b, c up to 97 000, other than three zeros, make a way of
/// no cost (the shortest of the lattice of those that do has length 169 158). Longer ways are possible in labyrinths
/// alone; those that are then taken for equal differ by less than 1e-10 sides.
using VoxelCost = std::uint64_t;
inline constexpr VoxelCost kVoxelStraight = 11'591'951'298;
inline constexpr VoxelCost kVoxelDiagonal = 16'393'494'740;
inline constexpr VoxelCost kVoxelTriple = 20'077'848'607;
/// No way costs as much: on the largest maps every cell may be passed by the dearest step.
inline constexpr VoxelCost kMostVoxelCost = ~VoxelCost{0} >> 1U;

/// Of the shortest way were all cells free; a consistent heuristic.
constexpr VoxelCost voxel_distance(int x, int y, int z) {
  std::array<VoxelCost, 3> sides{static_cast<VoxelCost>(x < 0 ? -x : x), static_cast<VoxelCost>(y < 0 ? -y : y),
                                 static_cast<VoxelCost>(z < 0 ? -z : z)};
  if (sides[0] < sides[1]) std::swap(sides[0], sides[1]);
  if (sides[1] < sides[2]) std::swap(sides[1], sides[2]);
  if (sides[0] < sides[1]) std::swap(sides[0], sides[1]);
  return kVoxelStraight * sides[0] + (kVoxelDiagonal - kVoxelStraight) * sides[1] +
         (kVoxelTriple - kVoxelDiagonal) * sides[2];
}

}  // namespace alate
