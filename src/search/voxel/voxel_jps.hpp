// Jump point search on voxels.
#pragma once

#include "search/voxel/voxel_moves.hpp"
#include "search/voxel/voxel_way.hpp"

namespace alate {

/// A place, and the step by which it was come to; or, to be `run`, the direction to leave it in.
struct VoxelJump {
  VoxelCost key = 0;
  VoxelPlace place;
  std::uint8_t direction = kNoVoxelDirection;
  bool run = false;
};

/// What is known of a cell: its cost, where the way to it came from, and all steps by which it was come to at that
/// cost.
struct VoxelJumpRecord {
  VoxelCost key = ~VoxelCost{0};
  VoxelMoves::Set entered = 0;
  std::uint16_t steps = 0;
  std::uint8_t direction = kNoVoxelDirection;
};

/// Jump point search (Harabor and Grastien 2011) in three dimensions (Nobes, Harabor, Wybrow and Walsh 2022): of all
/// shortest ways only the one that VoxelMoves puts first is followed. Straight runs are read 64 cells at a time from
/// bits that hold where they stop.
///
/// Departures. Runs across edges and corners, from which straight runs branch off at every cell, end where f rises and
/// go on once that is the least: otherwise they would sweep an open map up to its sides. So they are rather the
/// canonical A* of Sturtevant and Rabin (2016). Such runs end beside walls as well, as only there anything but
/// the natural successors can be needed. Cells that they pass are noted with their costs, and a run ends at a cell that
/// is known to cost less. A cell that is come to at the same cost by several steps is expanded once for each of them.
class VoxelJps : public GridBestFirst<VoxelJps, VoxelJump, VoxelSpace<VoxelJumpRecord>> {
 public:
  /// `grid` must outlive this.
  explicit VoxelJps(const VoxelBits& grid);

 private:
  friend class GridBestFirst;

  struct Origin {
    VoxelCost key = 0;
    VoxelPlace place;
  };

  void expand(const VoxelJump& entry);
  void trace(VoxelWay& way) const;
  void follow(const Origin& origin, unsigned direction);
  void run_straight(const Origin& origin, unsigned direction);
  void run_diagonally(Origin origin, unsigned direction);
  void branch_off(const Origin& origin, unsigned direction);
  bool note(const Origin& at, unsigned direction, unsigned steps);

  const VoxelMoves& moves_;
  VoxelCost level_ = 0;  ///< Runs go on up to this f.
};

}  // namespace alate
