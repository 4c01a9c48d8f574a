#include "search/voxel/voxel_way.hpp"

namespace alate {

namespace {

/// Of a straight flight between two places.
unsigned direction_of(VoxelPlace from, VoxelPlace to) {
  const auto sign = [](int difference) { return (difference > 0 ? 1 : 0) - (difference < 0 ? 1 : 0); };
  return voxel_direction({sign(to.x - from.x), sign(to.y - from.y), sign(to.z - from.z)});
}

}  // namespace

void add_steps_before(VoxelWay& way, unsigned direction, unsigned steps) {
  std::vector<VoxelPlace>& corners = way.corners;
  const VoxelPlace before = moved(corners.back(), direction, -static_cast<int>(steps));
  if (corners.size() > 1 && direction_of(corners.back(), corners[corners.size() - 2]) == direction) corners.pop_back();
  corners.push_back(before);
  const unsigned kind = kVoxelKinds[direction];
  (kind == 1 ? way.length.straights : kind == 2 ? way.length.diagonals : way.length.triples) += steps;
}

}  // namespace alate
