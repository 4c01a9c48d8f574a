// What exact searches on voxels are asked and answer.
#pragma once

#include <vector>

#include "search/grid/best_first.hpp"
#include "search/voxel/paged_table.hpp"
#include "search/voxel/voxel_bits.hpp"
#include "search/voxel/voxel_cost.hpp"

namespace alate {

/// A way from start to goal, or none.
struct VoxelWay {
  bool found = false;
  bool finished = false;  ///< False after a stop: then it is not proven that there is no way, or no shorter one.
  std::vector<VoxelPlace> corners;  ///< Start, the cells where the direction changes, goal.
  VoxelLength length;               ///< Of ways from cell to cell.
  std::uint64_t expansions = 0;
};

/// Adds `steps` steps in `direction`, the last first: traces lead from the goal back to the start.
void add_steps_before(VoxelWay& way, unsigned direction, unsigned steps);

/// By how much the priority of an open cell can exceed that of the one expanded, after runs of any length.
inline VoxelCost widest_spread(const VoxelBits& grid) {
  const auto& [x, y, z] = grid.size();
  return 2 * kVoxelTriple * (static_cast<VoxelCost>(x) + static_cast<VoxelCost>(y) + static_cast<VoxelCost>(z));
}

/// What a search needs to know of voxels.
template <class Record>
struct VoxelSpace {
  using Grid = VoxelBits;
  using Place = VoxelPlace;
  using Way = VoxelWay;
  using Costs = PagedTable<Record>;
  using Cost = VoxelCost;
  static constexpr Cost kMostCost = kMostVoxelCost;
  static constexpr unsigned kBucketBits = 30;
  static_assert((Cost{1} << kBucketBits) <= 2 * kVoxelDiagonal - kVoxelStraight - kVoxelTriple,
                "the least amount by which a step raises f");

  static Cost distance(Place a, Place b) {
    return voxel_distance(int{a.x} - int{b.x}, int{a.y} - int{b.y}, int{a.z} - int{b.z});
  }
};

}  // namespace alate
