#include "search/voxel/voxel_astar.hpp"

#include <algorithm>

namespace alate {

VoxelAStar::VoxelAStar(const VoxelBits& grid) : GridBestFirst(grid, 2 * kVoxelTriple), moves_(VoxelMoves::table()) {}

void VoxelAStar::expand(const VoxelAStarEntry& entry) {
  for (VoxelMoves::Set free = moves(entry.place); free != 0; free &= free - 1) {
    const auto d = static_cast<unsigned>(std::countr_zero(free));
    const VoxelPlace next = moved(entry.place, d);
    const VoxelCost key = entry.key + VoxelMoves::cost(d);
    VoxelCost& known = costs_[grid_.cell(next)];
    if (key >= known) continue;
    known = key;
    come_to({key, next});
  }
}

/// Back along steps whose costs add up, in one direction as long as they do.
void VoxelAStar::trace(VoxelWay& way) const {
  way.found = true;
  way.corners.push_back(goal_);
  unsigned d = 0;
  for (VoxelPlace at = goal_; at != start_; at = moved(at, d)) {
    const VoxelMoves::Set free = moves(at);
    const auto leads_back = [&](unsigned direction) {
      return ((free >> direction) & 1U) != 0 &&
             costs_[grid_.cell(moved(at, direction))] + VoxelMoves::cost(direction) == costs_[grid_.cell(at)];
    };
    for (unsigned turn = 0; !leads_back(d) && turn < kVoxelDirections; ++turn) d = (d + 1) % kVoxelDirections;
    add_steps_before(way, kVoxelDirections - 1 - d, 1);
  }
  std::ranges::reverse(way.corners);
}

}  // namespace alate
