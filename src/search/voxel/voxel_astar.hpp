// A* from voxel to voxel.
#pragma once

#include "search/voxel/voxel_moves.hpp"
#include "search/voxel/voxel_way.hpp"

namespace alate {

struct VoxelAStarEntry {
  VoxelCost key = 0;
  VoxelPlace place;
};

struct VoxelAStarRecord {
  VoxelCost key = ~VoxelCost{0};
};

/// A* (Hart, Nilsson and Raphael 1968) with 26 moves, no edge or corner of a blocked cell cut, and the length of the
/// shortest way were all cells free as heuristic.
class VoxelAStar : public GridBestFirst<VoxelAStar, VoxelAStarEntry, VoxelSpace<VoxelAStarRecord>> {
 public:
  /// `grid` must outlive this.
  explicit VoxelAStar(const VoxelBits& grid);

 private:
  friend class GridBestFirst;

  VoxelMoves::Set moves(VoxelPlace place) const {
    return moves_.free(grid_.is_beside_wall(place) ? grid_.around(place) : 0);
  }
  void expand(const VoxelAStarEntry& entry);
  void trace(VoxelWay& way) const;

  const VoxelMoves& moves_;
};

}  // namespace alate
