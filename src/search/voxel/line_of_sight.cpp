#include "search/voxel/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alate {

namespace {

/// The line leaves its k-th cell along an axis at the share (2 k - 1) / (2 d) of its way, d the cells it covers along
/// that axis. All such shares as whole numbers of one unit.
class Line {
 public:
  Line(VoxelPlace from, VoxelPlace to) {
    const std::array<int, 3> way{to.x - from.x, to.y - from.y, to.z - from.z};
    Share all = 1;
    for (const int axis : way) all *= axis == 0 ? 1 : static_cast<Share>(std::abs(axis));
    for (std::size_t axis = 0; axis < way.size(); ++axis) {
      if (way.at(axis) == 0) continue;
      sign_.at(axis) = way.at(axis) > 0 ? 1 : -1;
      next_.at(axis) = all / static_cast<Share>(std::abs(way.at(axis)));
      each_.at(axis) = 2 * next_.at(axis);
    }
  }

  /// The direction in which it leaves the cell that it is in; goes on to the next.
  unsigned step() {
    const Share share = std::ranges::min(next_);
    std::array<int, 3> shift{};
    for (std::size_t axis = 0; axis < shift.size(); ++axis) {
      if (next_.at(axis) != share) continue;
      next_.at(axis) += each_.at(axis);
      shift.at(axis) = sign_.at(axis);
    }
    return voxel_direction(shift);
  }

 private:
  using Share = std::uint64_t;
  static constexpr Share kNever = ~Share{0};

  std::array<int, 3> sign_{};
  std::array<Share, 3> next_{kNever, kNever, kNever};
  std::array<Share, 3> each_{};
};

}  // namespace

bool is_in_sight(const VoxelBits& bits, VoxelPlace from, VoxelPlace to) {
  const VoxelMoves& moves = VoxelMoves::table();
  Line line(from, to);
  for (VoxelPlace at = from; at != to;) {
    const unsigned direction = line.step();
    if (bits.is_beside_wall(at) && !moves.is_free(direction, bits.around(at))) return false;
    at = moved(at, direction);
  }
  return true;
}

double line_length(VoxelPlace from, VoxelPlace to) {
  return std::hypot(to.x - from.x, to.y - from.y, to.z - from.z) * static_cast<double>(kVoxelStraight);
}

}  // namespace alate
