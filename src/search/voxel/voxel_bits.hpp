// Blocked voxels as bits, made for exact search on large maps.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "alate/data/voxel_grid.hpp"

namespace alate {

/// A cell, counted with the rim: those of the map begin at 1.
struct VoxelPlace {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t z = 0;

  bool operator==(const VoxelPlace&) const = default;
};

/// Directions are numbered as the 27 cells around one are: x fastest, the cell itself in the middle.
inline constexpr unsigned kVoxelDirections = 27;
inline constexpr unsigned kNoVoxelDirection = 13;

inline constexpr std::array<std::array<int, 3>, kVoxelDirections> kVoxelShifts = [] {
  std::array<std::array<int, 3>, kVoxelDirections> shifts{};
  for (unsigned d = 0; d < kVoxelDirections; ++d)
    shifts.at(d) = {static_cast<int>(d % 3) - 1, static_cast<int>(d / 3 % 3) - 1, static_cast<int>(d / 9) - 1};
  return shifts;
}();

constexpr unsigned voxel_direction(const std::array<int, 3>& shift) {
  return static_cast<unsigned>((shift[2] + 1) * 9 + (shift[1] + 1) * 3 + shift[0] + 1);
}

/// Along how many axes a direction leads: 1 across a face, 2 an edge, 3 a corner.
inline constexpr std::array<unsigned, kVoxelDirections> kVoxelKinds = [] {
  std::array<unsigned, kVoxelDirections> kinds{};
  for (unsigned d = 0; d < kVoxelDirections; ++d)
    for (const int axis : kVoxelShifts.at(d)) kinds.at(d) += axis != 0 ? 1U : 0U;
  return kinds;
}();

constexpr VoxelPlace moved(VoxelPlace place, unsigned direction, int steps = 1) {
  const auto& shift = kVoxelShifts[direction];
  return {static_cast<std::uint16_t>(place.x + shift[0] * steps),
          static_cast<std::uint16_t>(place.y + shift[1] * steps),
          static_cast<std::uint16_t>(place.z + shift[2] * steps)};
}

/// Lanes of bits along one axis. A lane begins at a whole word; its first cell and those behind its last are rim.
class VoxelLanes {
 public:
  using Word = std::uint64_t;
  static constexpr unsigned kBits = 64;

  /// `lanes` of `length` cells between the rims, all bits zero.
  VoxelLanes(unsigned length, std::size_t lanes) : words_((length + 2 + kBits - 1) / kBits), bits_(words_ * lanes) {}

  unsigned words() const { return words_; }
  Word* lane(std::size_t number) { return bits_.data() + number * words_; }
  const Word* lane(std::size_t number) const { return bits_.data() + number * words_; }
  bool has(std::size_t number, unsigned along) const {
    return ((lane(number)[along / kBits] >> (along % kBits)) & 1U) != 0;
  }
  void set(std::size_t number, unsigned along) { lane(number)[along / kBits] |= Word{1} << (along % kBits); }
  /// Bits along - 1 to along + 1, of which the first is bit 0.
  unsigned three(std::size_t number, unsigned along) const {
    const Word* word = lane(number) + (along - 1) / kBits;
    const unsigned shift = (along - 1) % kBits;
    Word bits = *word >> shift;
    if (shift > kBits - 3) bits |= word[1] << (kBits - shift);
    return static_cast<unsigned>(bits) & 7U;
  }
  /// Steps to the next bit that is set; there is one.
  unsigned steps_ahead(std::size_t number, unsigned along) const {
    const Word* word = lane(number) + along / kBits;
    Word bits = *word & (~Word{1} << (along % kBits));
    unsigned steps = 0;
    for (; bits == 0; steps += kBits) bits = *++word;
    return steps + static_cast<unsigned>(std::countr_zero(bits)) - along % kBits;
  }
  unsigned steps_back(std::size_t number, unsigned along) const {
    const Word* word = lane(number) + along / kBits;
    Word bits = *word & ~(~Word{0} << (along % kBits));
    unsigned steps = along % kBits;
    for (; bits == 0; steps += kBits) bits = *--word;
    return steps + static_cast<unsigned>(std::countl_zero(bits)) - (kBits - 1);
  }

 private:
  unsigned words_;
  std::vector<Word> bits_;
};

/// What searches ask of a voxel map, worked out once: where cells are blocked, which free ones have a blocked one
/// around them, and where straight runs stop. Outside the map all is blocked.
class VoxelBits {
 public:
  using Cell = std::uint32_t;

  explicit VoxelBits(const VoxelGrid& grid);

  const VoxelCell& size() const { return size_; }
  static VoxelPlace place(const VoxelCell& cell) {
    return {static_cast<std::uint16_t>(cell[0] + 1), static_cast<std::uint16_t>(cell[1] + 1),
            static_cast<std::uint16_t>(cell[2] + 1)};
  }
  static VoxelCell cell_of(VoxelPlace place) { return {place.x - 1, place.y - 1, place.z - 1}; }
  bool is_free(VoxelPlace at) const { return !blocked_.has(lane(at), at.x); }
  /// Is any of the 26 cells around blocked?
  bool is_beside_wall(VoxelPlace at) const { return near_.has(lane(at), at.x); }
  /// Bit d: the cell in direction d is blocked.
  std::uint32_t around(VoxelPlace at) const {
    std::uint32_t bits = 0;
    const std::size_t middle = lane(at);
    for (unsigned row = 0; row < 9; ++row)
      bits |= blocked_.three(middle + (row / 3) * columns_[0] + row % 3 - columns_[0] - 1, at.x) << (3 * row);
    return bits;
  }

  struct Run {
    unsigned steps = 0;
    bool turns = false;  ///< Stops at a free cell; else at a blocked one.
  };
  /// From a free cell along an axis to the first that is blocked, or at which a shortest way may have to turn: one of
  /// the eight lanes beside it is free there and was blocked a cell before.
  Run run(VoxelPlace from, unsigned direction) const;

  /// Numbers cells for tables, those close to each other close together: by cubes of 64.
  Cell cell(VoxelPlace at) const {
    const Cell cube = ((at.z / kCube) * cubes_[1] + at.y / kCube) * cubes_[0] + at.x / kCube;
    return cube * kCubeCells + ((at.z % kCube) * kCube + at.y % kCube) * kCube + at.x % kCube;
  }
  std::size_t cells() const { return std::size_t{cubes_[0]} * cubes_[1] * cubes_[2] * kCubeCells; }
  static constexpr Cell kCube = 4;
  static constexpr Cell kCubeCells = kCube * kCube * kCube;

 private:
  /// Of lanes along x.
  std::size_t lane(VoxelPlace at) const { return at.y + std::size_t{columns_[0]} * at.z; }
  /// Lanes along `axis` are numbered by the other two, the next of them faster.
  std::size_t lane(VoxelPlace at, unsigned axis) const;
  VoxelLanes walls(const VoxelGrid& grid, unsigned axis) const;
  void note_stops(const VoxelLanes& walls, unsigned axis);

  VoxelCell size_;
  std::array<std::size_t, 3> columns_;  ///< By axis of the lanes: cells along the faster of the others, with rims.
  std::array<Cell, 3> cubes_{};
  VoxelLanes blocked_;
  VoxelLanes near_;
  std::vector<VoxelLanes> ahead_, back_;  ///< Stops of runs to larger and to smaller numbers, by axis.
};

}  // namespace alate
