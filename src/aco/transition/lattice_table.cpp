#include "aco/transition/lattice_table.hpp"

#include <algorithm>

namespace alate {

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
