#include "aco/transition/move_table.hpp"

#include <algorithm>

namespace alate {

/// Trails are taken as shares of the highest that leaves the cell: where all have evaporated long ago, ants still walk.
void MoveTable::rebuild(GridSpace::Cell cell, const Trail<MoveCells>& trail) {
  const TrailLevels levels = trail.levels();
  const StoredTrail* stored = trail.store().row(cell);
  const float* heuristic = &heuristic_[kRow * cell];
  float* weights = &weights_[kRow * cell];
  std::array<float, kRow> tau{};
  for (std::size_t d = 0; d < kRow; ++d) tau[d] = levels.read(stored[d]);
  float highest = tau[0];
  for (std::size_t d = 1; d < kRow; ++d) highest = tau[d] > highest ? tau[d] : highest;
  const float share = highest > std::numeric_limits<float>::min() ? 1 / highest : 0;
  for (std::size_t d = 0; d < kRow; ++d) tau[d] = share > 0 ? tau[d] * share : 1;
  std::copy_n(heuristic, kRow, weights);
  for (int i = 0; i < alpha_; ++i)
    for (std::size_t d = 0; d < kRow; ++d) weights[d] *= tau[d];
}

}  // namespace alate
