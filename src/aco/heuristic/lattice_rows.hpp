// How good each move of a terrain lattice looks, for tables: a row of 32 by node.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "space/terrain_lattice.hpp"

namespace alate {

/// weight(value, best) of every open move, 0 elsewhere: value(node, to, move) is the greater the better, `best` the
/// greatest of its row. So no weight of a row need be so small that single precision loses it; none is below 1e-12, as
/// trails or turn limits may leave no other move.
template <class Value, class Weight>
AlignedFloats lattice_rows(const TerrainLattice& lattice, const Value& value, const Weight& weight) {
  constexpr std::size_t kRow = TerrainLattice::kRow;
  constexpr double kLeast = 1e-12;
  const LatticeFrame& frame = lattice.frame();
  AlignedFloats table(kRow * frame.nodes());
  std::array<double, kRow> values{};
  for (TerrainLattice::Node node = 0; node < frame.nodes(); ++node) {
    const unsigned open = lattice.moves().open(node);
    if (open == 0) continue;
    const Vec3 from = frame.position(node);
    double best = -kInfinity;
    for (unsigned left = open; left != 0; left &= left - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(left));
      values[move] = value(node, from + frame.shifts()[move].leg, move);
      best = std::max(best, values[move]);
    }
    for (unsigned left = open; left != 0; left &= left - 1) {
      const auto move = static_cast<unsigned>(std::countr_zero(left));
      table[kRow * node + move] = static_cast<float>(std::max(kLeast, weight(values[move], best)));
    }
  }
  return table;
}

/// (value / best)^beta.
struct PowerOfShare {
  int beta = 1;

  double operator()(double value, double best) const {
    double power = 1;
    for (int i = 0; i < beta; ++i) power *= value / best;
    return power;
  }
};

}  // namespace alate
