#include "search/voxel/voxel_bits.hpp"

#include <algorithm>

namespace alate {

namespace {

using Word = VoxelLanes::Word;

constexpr std::array<unsigned, 3> kFaster{1, 0, 0};  ///< By axis of the lanes.
constexpr std::array<unsigned, 3> kSlower{2, 2, 1};

unsigned side(const VoxelCell& size, unsigned axis) { return static_cast<unsigned>(size.at(axis)); }

std::size_t lanes_of(const VoxelCell& size, unsigned axis) {
  return (std::size_t{side(size, kFaster.at(axis))} + 2) * (std::size_t{side(size, kSlower.at(axis))} + 2);
}

/// The word of a lane moved by one cell to larger numbers, or to smaller ones.
Word moved_ahead(const Word* lane, unsigned word) {
  return (lane[word] << 1U) | (word > 0 ? lane[word - 1] >> (VoxelLanes::kBits - 1) : 0);
}
Word moved_back(const Word* lane, unsigned word, unsigned words) {
  return (lane[word] >> 1U) | (word + 1 < words ? lane[word + 1] << (VoxelLanes::kBits - 1) : ~(~Word{0} >> 1U));
}

/// Calls `act(lane, beside)` for each lane of the map, not of the rim, with the nine that it is the middle of.
template <class Act>
void for_each_lane(const VoxelLanes& walls, const std::array<std::size_t, 2>& counts, const Act& act) {
  const auto [columns, rows] = counts;
  for (std::size_t row = 1; row + 1 < rows; ++row) {
    for (std::size_t column = 1; column + 1 < columns; ++column) {
      std::array<const Word*, 9> beside{};
      for (std::size_t i = 0; i < beside.size(); ++i)
        beside.at(i) = walls.lane((row + i / 3 - 1) * columns + column + i % 3 - 1);
      act(row * columns + column, beside);
    }
  }
}

std::array<std::size_t, 2> counts_of(const VoxelCell& size, unsigned axis) {
  return {std::size_t{side(size, kFaster.at(axis))} + 2, std::size_t{side(size, kSlower.at(axis))} + 2};
}

}  // namespace

VoxelBits::VoxelBits(const VoxelGrid& grid)
    : size_(grid.size()),
      columns_{counts_of(size_, 0)[0], counts_of(size_, 1)[0], counts_of(size_, 2)[0]},
      blocked_(walls(grid, 0)),
      near_(side(size_, 0), lanes_of(size_, 0)) {
  for (unsigned axis = 0; axis < 3; ++axis) cubes_.at(axis) = (side(size_, axis) + 2 + kCube - 1) / kCube;
  note_stops(blocked_, 0);
  for (const unsigned axis : {1U, 2U}) note_stops(walls(grid, axis), axis);
  for_each_lane(blocked_, counts_of(size_, 0), [&](std::size_t lane, const std::array<const Word*, 9>& beside) {
    for (unsigned word = 0; word < near_.words(); ++word) {
      for (const Word* each : beside)
        near_.lane(lane)[word] |= each[word] | moved_ahead(each, word) | moved_back(each, word, near_.words());
    }
  });
}

std::size_t VoxelBits::lane(VoxelPlace at, unsigned axis) const {
  const std::size_t faster = axis == 0 ? at.y : at.x;
  const std::size_t slower = axis == 2 ? at.y : at.z;
  return slower * columns_.at(axis) + faster;
}

VoxelLanes VoxelBits::walls(const VoxelGrid& grid, unsigned axis) const {
  const unsigned length = side(size_, axis);
  VoxelLanes walls(length, lanes_of(size_, axis));
  std::vector<Word> open(walls.words(), ~Word{0});
  for (unsigned along = 1; along <= length; ++along)
    open[along / VoxelLanes::kBits] &= ~(Word{1} << (along % VoxelLanes::kBits));
  const auto [columns, rows] = counts_of(size_, axis);
  for (std::size_t number = 0; number < columns * rows; ++number) {
    const std::size_t column = number % columns;
    const std::size_t row = number / columns;
    const bool inside = column > 0 && column + 1 < columns && row > 0 && row + 1 < rows;
    if (inside) {
      std::ranges::copy(open, walls.lane(number));
    } else {
      std::fill_n(walls.lane(number), walls.words(), ~Word{0});
    }
  }
  grid.for_each_blocked(
      [&](const VoxelCell& cell) { walls.set(lane(place(cell), axis), static_cast<unsigned>(cell.at(axis)) + 1); });
  return walls;
}

void VoxelBits::note_stops(const VoxelLanes& walls, unsigned axis) {
  const unsigned length = side(size_, axis);
  VoxelLanes& ahead = ahead_.emplace_back(length, lanes_of(size_, axis));
  VoxelLanes& back = back_.emplace_back(length, lanes_of(size_, axis));
  for_each_lane(walls, counts_of(size_, axis), [&](std::size_t lane, const std::array<const Word*, 9>& beside) {
    for (unsigned word = 0; word < walls.words(); ++word) {
      Word& stops_ahead = ahead.lane(lane)[word];
      Word& stops_back = back.lane(lane)[word];
      for (const Word* each : beside) {
        stops_ahead |= moved_ahead(each, word) & ~each[word];
        stops_back |= moved_back(each, word, walls.words()) & ~each[word];
      }
      const Word wall = walls.lane(lane)[word];
      stops_ahead |= wall;
      stops_back |= wall;
    }
  });
}

VoxelBits::Run VoxelBits::run(VoxelPlace from, unsigned direction) const {
  const auto& shift = kVoxelShifts[direction];
  const unsigned axis = shift[0] != 0 ? 0 : shift[1] != 0 ? 1 : 2;
  const unsigned along = axis == 0 ? from.x : axis == 1 ? from.y : from.z;
  const std::size_t number = lane(from, axis);
  const unsigned steps =
      shift[axis] > 0 ? ahead_[axis].steps_ahead(number, along) : back_[axis].steps_back(number, along);
  return {steps, is_free(moved(from, direction, static_cast<int>(steps)))};
}

}  // namespace alate
