// From a problem among voxels to a search, and from its ways to legs.
#pragma once

#include <string>
#include <vector>

#include "alate/plan/registry.hpp"
#include "search/voxel/voxel_way.hpp"

namespace alate {

/// Empty if planners that step from voxel to voxel can serve the problem, else why not.
std::string voxel_refusal(const Problem& problem);

/// Where a route begins and ends.
struct VoxelEnds {
  VoxelPlace start;
  VoxelPlace goal;
};

/// Of a problem that is not refused.
VoxelEnds voxel_ends(const Problem& problem);

/// What legs among voxels have in common, for CellExact: places are middles of cells.
struct VoxelLegs {
  using Cells = VoxelBits;
  static VoxelEnds ends(const Problem& problem) { return voxel_ends(problem); }
  static std::vector<Vec3> places(const Problem& problem, const VoxelBits& cells, const VoxelWay& way);
  static double proven_cost(const Problem& /*problem*/, const VoxelWay& /*way*/, double cost) { return cost; }
  static std::string no_way(const Problem& problem);
};

/// Legs in the 26 directions.
struct VoxelToVoxel : VoxelLegs {
  static constexpr bool kProven = true;
  /// Metres: the shortest way were all cells free.
  static double least_length(const Problem& problem);
};

/// Legs at any angle, short but not proven the shortest.
struct VoxelLines : VoxelLegs {
  static constexpr bool kProven = false;
  /// Metres: the straight line.
  static double least_length(const Problem& problem);
};

}  // namespace alate
