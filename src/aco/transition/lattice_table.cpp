#include "aco/transition/lattice_table.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "space/simd.hpp"

namespace alate {

namespace {

/// In [0, 1), from the upper 24 bits.
float uniform(std::uint64_t bits) { return static_cast<float>(static_cast<std::int32_t>(bits >> 40U)) * 0x1.0p-24F; }

/// Joins all lanes; every lane then holds what came out.
template <class Vector, class Join>
[[gnu::always_inline]] inline void fold(Vector& lanes, Join join) {
  join(lanes, __builtin_shufflevector(lanes, lanes, 2, 3, 0, 1));
  join(lanes, __builtin_shufflevector(lanes, lanes, 1, 0, 3, 2));
}

}  // namespace

LatticeTable::LatticeTable(const TerrainLattice& lattice, AlignedFloats heuristic, const LatticeTableRule& rule)
    : lattice_(lattice), heuristic_(std::move(heuristic)), weights_(heuristic_), rule_(rule) {
  for (unsigned came = 0; came < may_.size(); ++came)
    for (unsigned m = 0; m < lattice.frame().moves(); ++m)
      may_[came][m] = ((lattice.moves().follows(came) >> m) & 1U) != 0 ? -1 : 0;
}

void LatticeTable::prepare(Trail<LatticeCells>& trail, std::uint64_t n, std::uint64_t most) {
  q0_ = static_cast<float>(rule_.q0(n, most));
  const LatticeCells& store = trail.store();
  for (const Node node : rule_.bounded ? store.known_rows() : store.changed_rows()) rebuild(node, trail);
  trail.store().forget_changes();
}

[[gnu::always_inline]] inline LatticeTable::Quad LatticeTable::weights(Node node, unsigned came,
                                                                       std::size_t from) const {
  QuadMask weights;
  QuadMask may;
  std::memcpy(&weights, &weights_[kRow * node + from], sizeof weights);
  std::memcpy(&may, &may_[came][from], sizeof may);
  return std::bit_cast<Quad>(weights & may);
}

[[gnu::always_inline]] inline unsigned LatticeTable::draw(Node node, unsigned came, float uniform) const {
  // Running sums down the rows, by lane; filled before use.
  std::array<Quad, kQuads> until;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  until[0] = weights(node, came, 0);
  for (std::size_t i = 1; i < kQuads; ++i) until[i] = until[i - 1] + weights(node, came, 4 * i);
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
  const bool may_go = move < LatticeStands::kNoMove && weights_[kRow * node + move] > 0 && may_[came][move] != 0;
  return may_go ? move : heaviest(node, came);  // nothing left; or a sum was rounded up
}

/// The first of equals.
[[gnu::always_inline]] inline unsigned LatticeTable::heaviest(Node node, unsigned came) const {
  constexpr QuadMask kInRow{0, 1, 2, 3};
  constexpr std::int32_t kNone = LatticeStands::kNoMove;
  Quad most{};  // by lane, and which move
  QuadMask move = QuadMask{} + kNone;
  for (std::size_t i = 0; i < kQuads; ++i) {
    const Quad quad = weights(node, came, 4 * i);
    const QuadMask more = quad > most;
    most = more ? quad : most;
    move = more ? kInRow + static_cast<std::int32_t>(4 * i) : move;
  }
  Quad best = most;
  fold(best, [](Quad& larger, const Quad& other) { larger = other > larger ? other : larger; });
  move = most == best ? move : QuadMask{} + kNone;
  fold(move, [](QuadMask& first, const QuadMask& other) { first = other < first ? other : first; });
  return static_cast<unsigned>(move[0]);
}

ALATE_SIMD void LatticeTable::choose(const LatticeStands& ants, LatticeStands::Moves& moves) const {
  std::array<std::array<std::uint8_t, LatticeStands::kMost>, 2> who{};  // those that draw, those that take the best
  std::array<std::size_t, 2> count{};
  for (std::size_t i = ants.count; i-- > 0;) {  // as their weights were asked for
    const auto takes_best = static_cast<std::size_t>(uniform(ants.bits[i]) < q0_);
    who[takes_best][count[takes_best]++] = static_cast<std::uint8_t>(i);
  }
  for (std::size_t k = 0; k < count[0]; ++k) {
    const std::size_t i = who[0][k];
    moves[i] = draw(ants.node[i], ants.came[i], uniform(ants.bits[i] << 32U));
  }
  for (std::size_t k = 0; k < count[1]; ++k) {
    const std::size_t i = who[1][k];
    moves[i] = heaviest(ants.node[i], ants.came[i]);
  }
}

/// Trails are taken as shares of the highest that leaves the node: where all have evaporated long ago, ants still walk.
void LatticeTable::rebuild(Node node, const Trail<LatticeCells>& trail) {
  const TrailLevels levels = trail.levels();
  std::array<float, kRow> tau = trail.store().row(node, lattice_.moves().open(node));
  for (float& one : tau) one = levels.read(one);
  float highest = 0;
  for (const float one : tau) highest = one > highest ? one : highest;
  const float share = highest > std::numeric_limits<float>::min() ? 1 / highest : 0;
  for (float& one : tau) one = share > 0 ? one * share : 1;
  const float* heuristic = &heuristic_[kRow * node];
  float* weights = &weights_[kRow * node];
  std::copy_n(heuristic, kRow, weights);
  for (int i = 0; i < rule_.alpha; ++i)
    for (std::size_t m = 0; m < kRow; ++m) weights[m] *= tau[m];
}

}  // namespace alate
