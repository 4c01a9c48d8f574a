// Sites on drawn voxel maps, and their shortest ways.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <vector>

#include "alate/data/site.hpp"

namespace alate::test {

/// From the lowest to the highest corner, which are free.
inline Site voxel_site(VoxelGrid voxels) {
  const auto& [x, y, z] = voxels.size();
  const VoxelCell last{x - 1, y - 1, z - 1};
  Site site;
  site.scenario.objective.climb = 0;
  site.mission.start = voxels.center({0, 0, 0});
  site.mission.goal = voxels.center(last);
  site.voxels = std::move(voxels);
  return site;
}

/// Cells blocked at random, each with a chance of so many in a hundred; the corners between which sites fly are free.
inline VoxelGrid drawn_voxels(const VoxelCell& size, unsigned percent, std::mt19937_64& random) {
  VoxelGrid voxels(size);
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z)
        if (random() % 100 < percent) voxels.block({x, y, z});
  voxels.free({0, 0, 0});
  voxels.free({size[0] - 1, size[1] - 1, size[2] - 1});
  return voxels;
}

/// Are all cells of the box between a cell and one of its neighbours free?
inline bool is_free_step(const VoxelGrid& voxels, const VoxelCell& from, const VoxelCell& step) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto part = [&](unsigned axis) { return ((corner >> axis) & 1U) != 0 ? step.at(axis) : 0; };
    if (!voxels.is_free({from[0] + part(0), from[1] + part(1), from[2] + part(2)})) return false;
  }
  return true;
}

/// Dijkstra's algorithm word for word, cell sides; infinite where there is no way.
inline double shortest_length(const VoxelGrid& voxels, const VoxelCell& start, const VoxelCell& goal) {
  using Entry = std::pair<double, VoxelCell>;
  std::vector<double> length(voxels.count(), std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  length[voxels.index(start)] = 0;
  open.emplace(0, start);
  while (!open.empty()) {
    const auto [here, cell] = open.top();
    open.pop();
    if (here > length[voxels.index(cell)]) continue;
    for (int i = 0; i < 27; ++i) {
      const VoxelCell step{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
      if (!is_free_step(voxels, cell, step)) continue;
      const VoxelCell next{cell[0] + step[0], cell[1] + step[1], cell[2] + step[2]};
      const double there = here + std::hypot(step[0], step[1], step[2]);
      if (!(there < length[voxels.index(next)])) continue;
      length[voxels.index(next)] = there;
      open.emplace(there, next);
    }
  }
  return length[voxels.index(goal)];
}

}  // namespace alate::test
