// Ways at any angle among voxels.
#pragma once

#include "search/voxel/voxel_jps.hpp"

namespace alate {

struct VoxelThetaRecord {
  VoxelCost key = ~VoxelCost{0};
  VoxelPlace parent;
  bool closed = false;
};

/// Lazy Theta* (Nash, Koenig and Tovey 2010) on 26 neighbours, with an exact line of sight and the straight line to the
/// goal as heuristic: ways turn in the middles of cells only. Lengths are rounded to the unit of VoxelCost, 1e-10
/// sides.
///
/// Departures. Jump point search goes first: it proves that there is no way, and its way, with every turn cut short
/// that the line of sight allows, stands in where that is shorter or Theta* was stopped. So the way is never longer
/// than the shortest from cell to cell. The open list is one of buckets.
class VoxelTheta {
 public:
  /// `grid` must outlive this.
  explicit VoxelTheta(const VoxelBits& grid)
      : grid_(grid), moves_(VoxelMoves::table()), jps_(grid), costs_(grid.cells()), open_(widest_spread(grid)) {}

  /// Between free cells of the map. The way's `length`, which counts steps, stays empty.
  VoxelWay find(VoxelPlace start, VoxelPlace goal, RunContext& run);

 private:
  using Way = std::vector<VoxelPlace>;
  struct Entry {
    VoxelCost key = 0;
    VoxelPlace place;
  };

  bool search(VoxelPlace start, VoxelPlace goal, RunContext& run);
  VoxelMoves::Set moves(VoxelPlace place) const {
    return moves_.free(grid_.is_beside_wall(place) ? grid_.around(place) : 0);
  }
  void settle(VoxelPlace place, VoxelMoves::Set free);
  void expand(VoxelPlace place, VoxelMoves::Set free);
  Way trace(VoxelPlace start, VoxelPlace goal) const;
  Way cut_short(const Way& way) const;

  const VoxelBits& grid_;
  const VoxelMoves& moves_;
  VoxelJps jps_;
  PagedTable<VoxelThetaRecord> costs_;
  BucketQueue<Entry, VoxelSpace<VoxelThetaRecord>::kBucketBits> open_;
  VoxelPlace goal_;
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
