// Straight lines among voxels.
#pragma once

#include "search/voxel/voxel_moves.hpp"

namespace alate {

/// Is the straight line between the middles of two cells free, of which the first is? Decided in whole numbers: it
/// passes through free cells only, and where it leaves one across an edge or a corner, that step is free.
bool is_in_sight(const VoxelBits& bits, VoxelPlace from, VoxelPlace to);

/// Distance between the middles of two cells in the unit of VoxelCost.
double line_length(VoxelPlace from, VoxelPlace to);

}  // namespace alate
