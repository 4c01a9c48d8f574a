// Four ants side by side, one in each lane of a register: what every x86-64 has, for any compiler that knows vectors of
// the GNU kind. No lane knows of another, so it does not matter who walks beside whom.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "alate/core/stream.hpp"
#include "space/height_grid.hpp"

namespace alate {

inline constexpr std::size_t kAntLanes = 4;
using LaneFloats = float __attribute__((vector_size(16)));
using LaneBits = std::int32_t __attribute__((vector_size(16)));  ///< As a mask: all bits of a lane, or none.
/// A value of every move, by direction.
using MoveLanes = std::array<LaneFloats, GridSpace::kDirections>;

inline LaneFloats larger(const LaneFloats& a, const LaneFloats& b) { return a > b ? a : b; }
inline LaneFloats smaller(const LaneFloats& a, const LaneFloats& b) { return a < b ? a : b; }
/// The values where the mask is set, 0 elsewhere.
inline LaneFloats keep(const LaneFloats& values, const LaneBits& mask) {
  return std::bit_cast<LaneFloats>(std::bit_cast<LaneBits>(values) & mask);
}

using LaneStreams = std::array<Stream*, kAntLanes>;
/// In [0, 1), 24 bits, each from its own stream.
inline LaneFloats draw_uniform(const LaneStreams& streams) {
  const auto draw = [&](std::size_t i) { return static_cast<std::int32_t>(streams[i]->bits() >> 40U); };
  return __builtin_convertvector(LaneBits{draw(0), draw(1), draw(2), draw(3)}, LaneFloats) * 0x1.0p-24F;
}

inline LaneFloats load_four(const float* values) {
  LaneFloats lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

/// Lane i: the eight values at rows[i].
inline MoveLanes load_rows(const std::array<const float*, kAntLanes>& rows) {
  MoveLanes lanes;
  for (std::size_t half = 0; half < lanes.size(); half += kAntLanes) {
    const std::array<LaneFloats, kAntLanes> ant{load_four(rows[0] + half), load_four(rows[1] + half),
                                                load_four(rows[2] + half), load_four(rows[3] + half)};
    const LaneFloats a = __builtin_shufflevector(ant[0], ant[1], 0, 4, 1, 5);
    const LaneFloats b = __builtin_shufflevector(ant[2], ant[3], 0, 4, 1, 5);
    const LaneFloats c = __builtin_shufflevector(ant[0], ant[1], 2, 6, 3, 7);
    const LaneFloats d = __builtin_shufflevector(ant[2], ant[3], 2, 6, 3, 7);
    lanes[half] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
    lanes[half + 1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    lanes[half + 2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
    lanes[half + 3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
  }
  return lanes;
}

/// Random proportional rule: the first direction up to which weights >= 0 sum to more than uniform times all of them,
/// so never one that weighs 0; 8 if none weighs anything, or all together too little to be divided.
inline LaneBits pick(MoveLanes weights, const LaneFloats& uniform) {
  for (std::size_t d = 1; d < weights.size(); ++d) weights[d] += weights[d - 1];
  const LaneFloats point = weights.back() * uniform;
  LaneBits passed{};  // -1 each
  for (const LaneFloats& until : weights) passed += until <= point;
  return -passed;
}

/// The direction with the largest weight, the first of equal ones; 8 if none is above 0.
inline LaneBits heaviest(const MoveLanes& weights) {
  LaneFloats most{};
  LaneBits best = LaneBits{} + static_cast<std::int32_t>(weights.size());
  for (std::size_t d = 0; d < weights.size(); ++d) {
    const LaneBits more = weights[d] > most;
    best = (best & ~more) | (static_cast<std::int32_t>(d) & more);
    most = larger(weights[d], most);
  }
  return best;
}

/// Where four ants are, as a choice of moves sees it.
struct GridStands {
  std::array<GridSpace::Cell, kAntLanes> cell{};
  std::array<unsigned, kAntLanes> came{};  ///< Direction of the last move.
  /// What cells bear that an ant visited, in all four bytes.
  LaneBits mark{};
  /// What cells bear in the rows north of an ant, its own and south of it: from the west a byte each, and a fourth that
  /// means nothing.
  std::array<LaneBits, 3> marks{};

  /// All bits where the neighbour in direction d has not been visited.
  LaneBits left(unsigned direction) const {
    constexpr std::array<std::uint8_t, GridSpace::kDirections> kRow{1, 0, 0, 0, 1, 2, 2, 2};
    constexpr std::array<std::int32_t, 3> kBytes{0xFF, 0xFF00, 0xFF0000};
    constexpr std::array<std::uint8_t, GridSpace::kDirections> kByte{2, 2, 1, 0, 0, 0, 1, 2};
    return ((marks[kRow[direction]] ^ mark) & kBytes[kByte[direction]]) != 0;
  }

  /// Rows of eight by cell.
  MoveLanes load(const AlignedFloats& table) const {
    constexpr std::size_t kRow = GridSpace::kDirections;
    std::array<const float*, kAntLanes> rows{};
    for (std::size_t i = 0; i < kAntLanes; ++i) rows[i] = &table[kRow * cell[i]];
    return load_rows(rows);
  }
};

}  // namespace alate
