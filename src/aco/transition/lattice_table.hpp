// Moves of a terrain lattice drawn from a table: for each node the weights tau^alpha eta^beta of its moves, built again
// where trails have changed.
//
// Source: Mai et al. 2023, eq. (7), verbatim, and (14), reconstructed: the pseudo-random proportional rule of Dorigo,
// Gambardella 1997. Turn limits are a mask by the last move. A draw sums 28 weights in four lanes, draws the lane and
// then the row: no branch depends on chance but the one on q0.
#pragma once

#include <array>
#include <bit>
#include <cstring>

#include "aco/pheromone/lattice_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/q0_schedule.hpp"
#include "alate/core/stream.hpp"

namespace alate {

struct LatticeTableRule {
  int alpha = 1;
  Q0Schedule q0;
  bool bounded = false;  ///< Trails evaporate everywhere and meet bounds: shares change without a deposit.
};

class LatticeTable {
 public:
  using Node = TerrainLattice::Node;
  static constexpr unsigned kNoMove = TerrainLattice::kRow;

  /// `heuristic`: eta^beta in rows of kRow by node; 0 where a move is not open. `lattice` must outlive this.
  LatticeTable(const TerrainLattice& lattice, AlignedFloats heuristic, const LatticeTableRule& rule);

  /// Before iteration `n` (from 0) of `most`.
  void prepare(Trail<LatticeCells>& trail, std::uint64_t n, std::uint64_t most);

  /// Asks memory for the weights of a node, for when an ant will choose there.
  void fetch(Node node) const {
    __builtin_prefetch(&weights_[kRow * node]);
    __builtin_prefetch(&weights_[kRow * node + kRow / 2]);
  }

  /// kNoMove where no candidate is left.
  unsigned operator()(Node node, unsigned came, Stream& stream) const {
    const std::uint64_t bits = stream.bits();
    return uniform(bits) < q0_ ? heaviest(node, came) : draw(node, came, uniform(bits << 32U));
  }

 private:
  static constexpr std::size_t kRow = TerrainLattice::kRow;
  static constexpr std::size_t kQuads = 7;  ///< Of 4 lanes: enough for 25 moves.
  using Quad = float __attribute__((vector_size(16)));
  using QuadMask = std::int32_t __attribute__((vector_size(16)));
  using Lanes = std::array<std::int32_t, kRow>;

  /// In [0, 1), from the upper 24 bits.
  static float uniform(std::uint64_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits >> 40U)) * 0x1.0p-24F;
  }
  template <class Vector, class Value>
  static Vector load(const Value* from) {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
  }
  static Quad only(Quad values, QuadMask mask) { return std::bit_cast<Quad>(std::bit_cast<QuadMask>(values) & mask); }

  unsigned draw(Node node, unsigned came, float uniform) const {
    const float* row = &weights_[kRow * node];
    const std::int32_t* may = may_[came].data();
    // Running sums down the rows, by lane; filled before use.
    std::array<Quad, kQuads> until;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    until[0] = only(load<Quad>(row), load<QuadMask>(may));
    for (std::size_t i = 1; i < kQuads; ++i)
      until[i] = until[i - 1] + only(load<Quad>(row + 4 * i), load<QuadMask>(may + 4 * i));
    constexpr Quad kNone{};
    Quad lanes = until.back();
    lanes += __builtin_shufflevector(kNone, lanes, 0, 4, 5, 6);
    lanes += __builtin_shufflevector(kNone, lanes, 0, 1, 4, 5);
    const float point = uniform * lanes[3];
    const QuadMask passed = lanes <= point;  // -1 each
    const auto lane = static_cast<unsigned>(-(passed[0] + passed[1] + passed[2]));
    const Quad before = __builtin_shufflevector(kNone, lanes, 0, 4, 5, 6);
    const float left = point - before[lane];
    QuadMask rows{};
    for (const Quad& sums : until) rows += sums <= left;
    const unsigned move = 4 * static_cast<unsigned>(-rows[lane]) + lane;
    const bool may_go = move < 4 * kQuads && row[move] > 0 && may[move] != 0;
    return may_go ? move : heaviest(node, came);  // nothing left; or a sum was rounded up
  }

  /// The first of equals.
  unsigned heaviest(Node node, unsigned came) const {
    const float* row = &weights_[kRow * node];
    const std::int32_t* may = may_[came].data();
    Quad most{};  // by lane, and in which row
    QuadMask in = QuadMask{} + static_cast<std::int32_t>(kQuads);
    for (std::size_t i = 0; i < kQuads; ++i) {
      const Quad weights = only(load<Quad>(row + 4 * i), load<QuadMask>(may + 4 * i));
      const QuadMask more = weights > most;
      most = more ? weights : most;
      in = more ? QuadMask{} + static_cast<std::int32_t>(i) : in;
    }
    // Bits of positive weights are in order; a key ends in how early the move comes. No branches.
    const auto weights = std::bit_cast<std::array<std::uint32_t, 4>>(most);
    const auto rows = std::bit_cast<std::array<std::uint32_t, 4>>(in);
    std::uint64_t best = 0;
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      const std::uint64_t key = (std::uint64_t{weights[lane]} << 32U) | (kNoMove - 4 * rows[lane] - lane);
      best = key > best ? key : best;
    }
    return (best >> 32U) != 0 ? kNoMove - static_cast<unsigned>(best) : kNoMove;
  }
  void rebuild(Node node, const Trail<LatticeCells>& trail);

  const TerrainLattice& lattice_;
  AlignedFloats heuristic_, weights_;
  std::vector<std::uint8_t> best_;                       ///< The heaviest move of each node, the first of equals.
  std::array<Lanes, TerrainLattice::kFirst + 1> may_{};  ///< By the last move: all bits of a lane that may follow.
  LatticeTableRule rule_;
  float q0_ = 0;
};

}  // namespace alate
