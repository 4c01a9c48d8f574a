#include "aco/transition/move_table.hpp"

#include <limits>

namespace alate {

void MoveTable::prepare(const Trail<MoveCells>& trail) {
  const TrailLevels levels = trail.levels();
  for (const GridSpace::Cell cell : trail.store().known_cells()) rebuild(cell, trail.store().row(cell), levels);
}

/// Trails are taken as shares of the highest that leaves the cell: where all have evaporated long ago, ants still walk.
/// A share has a floor that no chance comes near: numbers that small are slow, and ants left with such moves still
/// walk.
void MoveTable::rebuild(GridSpace::Cell cell, const StoredTrail* stored, const TrailLevels& levels) {
  constexpr float kLeast = std::numeric_limits<float>::min();
  constexpr float kLeastShare = 1e-20F;
  const std::array<LaneFloats, 2> tau{levels.read(load_four(stored)), levels.read(load_four(stored + 4))};
  LaneFloats most = larger(tau[0], tau[1]);
  most = larger(most, __builtin_shufflevector(most, most, 2, 3, 0, 1));
  most = larger(most, __builtin_shufflevector(most, most, 1, 0, 3, 2));
  for (std::size_t half = 0; half < 2; ++half) {
    const std::size_t at = kRow * cell + 4 * half;
    const LaneFloats of_most = larger(tau[half], most * kLeastShare) / most;
    const LaneFloats share = most > kLeast ? of_most : LaneFloats{} + 1;
    LaneFloats weights = load_four(&heuristic_[at]);
    for (int i = 0; i < alpha_; ++i) weights *= share;
    std::memcpy(&weights_[at], &weights, sizeof weights);
  }
}

}  // namespace alate
