// Moves drawn from a table: for each cell the eight weights tau^alpha eta^beta, built again where trails have changed.
//
// Random proportional rule (Dorigo, Maniezzo, Colorni 1996, eq. (4)); with chance q0 the heaviest move instead (Dorigo,
// Gambardella 1997, eq. (3)). A draw masks the visited neighbours, sums and compares eight weights side by side,
// without a branch that depends on chance: each would cost more than all of that.
#pragma once

#include <array>
#include <bit>
#include <cstring>

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/grid_walk.hpp"
#include "alate/core/stream.hpp"

namespace alate {

class MoveTable {
 public:
  /// `heuristic`: eta^beta of every move by cell, as GridSpace numbers them; 0 where it is not free.
  MoveTable(AlignedFloats heuristic, int alpha, double q0)
      : heuristic_(std::move(heuristic)), weights_(heuristic_), alpha_(alpha), q0_(static_cast<float>(q0)) {}

  /// On cells that no trail has left all eight are alike and change nothing.
  void prepare(const Trail<MoveCells>& trail) {
    for (const GridSpace::Cell cell : trail.store().known_cells()) rebuild(cell, trail);
  }

  unsigned operator()(const GridStand& at, Stream& stream) const {
    if (q0_ > 0 && drawn(stream) < q0_) return heaviest(at);
    return draw(at, drawn(stream));
  }

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;
  // Four lanes are what every x86-64 has; written for any compiler that knows vectors of the GNU kind.
  using Quad = float __attribute__((vector_size(16)));
  using QuadMask = std::int32_t __attribute__((vector_size(16)));
  using Lanes = std::array<std::int32_t, kRow>;

  /// In [0, 1), 24 bits.
  static float drawn(Stream& stream) {
    return static_cast<float>(static_cast<std::int32_t>(stream.bits() >> 40U)) * 0x1.0p-24F;
  }
  template <class Vector, class Value>
  static Vector load(const Value* from) {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
  }
  static Quad only(Quad values, QuadMask mask) { return std::bit_cast<Quad>(std::bit_cast<QuadMask>(values) & mask); }
  static Quad running(Quad sums) {
    constexpr Quad kNone{};
    sums += __builtin_shufflevector(kNone, sums, 0, 4, 5, 6);
    return sums + __builtin_shufflevector(kNone, sums, 0, 1, 4, 5);
  }

  unsigned draw(const GridStand& at, float uniform) const {
    const float* row = &weights_[kRow * at.cell];
    const std::int32_t* left = left_[at.tabu].data();
    const Quad low = only(load<Quad>(row), load<QuadMask>(left));
    const Quad high = only(load<Quad>(row + 4), load<QuadMask>(left + 4));
    const Quad until_low = running(low);
    const Quad until_high = running(high) + until_low[3];
    const float point = uniform * until_high[3];
    const QuadMask passed = (until_low <= point) + (until_high <= point);  // -1 each
    const auto direction = static_cast<unsigned>(-(passed[0] + passed[1] + passed[2] + passed[3]));
    const bool may_go = direction < kRow && (direction < 4 ? low[direction] : high[direction - 4]) > 0;
    return may_go ? direction : heaviest(at);  // nothing left; or a sum was rounded up
  }

  unsigned heaviest(const GridStand& at) const;
  void rebuild(GridSpace::Cell cell, const Trail<MoveCells>& trail);

  static constexpr std::array<Lanes, 256> masks() {
    std::array<Lanes, 256> masks{};
    for (unsigned tabu = 0; tabu < masks.size(); ++tabu)
      for (unsigned d = 0; d < kRow; ++d) masks[tabu][d] = ((tabu >> d) & 1U) != 0 ? 0 : -1;
    return masks;
  }
  /// By visited neighbours: all bits of a lane where it may be gone to.
  static const std::array<Lanes, 256> left_;

  AlignedFloats heuristic_, weights_;
  int alpha_;
  float q0_;
};

inline constexpr std::array<MoveTable::Lanes, 256> MoveTable::left_ = MoveTable::masks();

}  // namespace alate
