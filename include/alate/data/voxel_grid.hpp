// A map of cubes, free or blocked: the air of planners that step from cell to cell in three dimensions.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

/// Numbers of a cell along x, y and z, from 0.
using VoxelCell = std::array<int, 3>;

/// Cell [x, y, z] fills (x to x + 1, y to y + 1, z to z + 1) * cell_m of a local frame, z up. Each takes one bit.
class VoxelGrid {
 public:
  VoxelGrid() = default;
  /// All cells free.
  explicit VoxelGrid(const VoxelCell& cells, double side_m = 1)
      : cell_m(side_m), size_(cells), bits_((count() + kBits - 1) / kBits) {}

  double cell_m = 1;

  /// Cells along each axis.
  const VoxelCell& size() const { return size_; }
  std::size_t count() const { return as_size(size_[0]) * as_size(size_[1]) * as_size(size_[2]); }
  bool contains(const VoxelCell& cell) const {
    return cell[0] >= 0 && cell[0] < size_[0] && cell[1] >= 0 && cell[1] < size_[1] && cell[2] >= 0 &&
           cell[2] < size_[2];
  }
  /// Of a cell that the map contains, x fastest.
  std::size_t index(const VoxelCell& cell) const {
    return (as_size(cell[2]) * as_size(size_[1]) + as_size(cell[1])) * as_size(size_[0]) + as_size(cell[0]);
  }
  bool blocked_at(const VoxelCell& cell) const {
    const std::size_t at = index(cell);
    return ((bits_[at / kBits] >> (at % kBits)) & 1U) != 0;
  }
  bool is_free(const VoxelCell& cell) const { return contains(cell) && !blocked_at(cell); }
  void block(const VoxelCell& cell) { bits_[index(cell) / kBits] |= std::uint64_t{1} << (index(cell) % kBits); }
  void free(const VoxelCell& cell) { bits_[index(cell) / kBits] &= ~(std::uint64_t{1} << (index(cell) % kBits)); }
  /// Calls `act(cell)` for every blocked cell, x fastest.
  template <class Act>
  void for_each_blocked(const Act& act) const;

  Vec3 center(const VoxelCell& cell) const { return (Vec3(cell[0], cell[1], cell[2]) + Vec3::Constant(0.5)) * cell_m; }
  /// The cell around `at`; nothing outside the map.
  std::optional<VoxelCell> cell_at(const Vec3& at) const {
    const Vec3 place = (at / cell_m).array().floor();
    const bool inside = (place.array() >= 0).all() && (place.array() < extent().array()).all();
    if (!inside) return std::nullopt;
    return VoxelCell{static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z())};
  }
  /// Cells along each axis as lengths.
  Vec3 extent() const {
    return {static_cast<double>(size_[0]), static_cast<double>(size_[1]), static_cast<double>(size_[2])};
  }
  /// Seen from above.
  Box2 area() const { return {Vec2::Zero(), extent().head<2>() * cell_m}; }

 private:
  static constexpr std::size_t kBits = 64;
  static std::size_t as_size(int side) { return static_cast<std::size_t>(side); }

  VoxelCell size_{};
  std::vector<std::uint64_t> bits_;
};

template <class Act>
void VoxelGrid::for_each_blocked(const Act& act) const {
  const auto columns = as_size(size_[0]);
  const auto rows = as_size(size_[1]);
  for (std::size_t word = 0; word < bits_.size(); ++word) {
    for (std::uint64_t bits = bits_[word]; bits != 0; bits &= bits - 1) {
      const std::size_t at = word * kBits + static_cast<std::size_t>(std::countr_zero(bits));
      act(VoxelCell{static_cast<int>(at % columns), static_cast<int>(at / columns % rows),
                    static_cast<int>(at / columns / rows)});
    }
  }
}

}  // namespace alate
