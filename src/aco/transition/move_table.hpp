// Moves drawn from a table: for each cell the eight weights tau^alpha eta^beta, built again where trails have changed.
//
// Random proportional rule (Dorigo, Maniezzo, Colorni 1996, eq. (4)); with chance q0 the heaviest move instead (Dorigo,
// Gambardella 1997, eq. (3)). No branch depends on chance: each would cost more than a draw.
#pragma once

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/lanes.hpp"

namespace alate {

class MoveTable {
 public:
  /// `heuristic`: eta^beta of every move by cell, as GridSpace numbers them; 0 where it is not free.
  MoveTable(AlignedFloats heuristic, int alpha, double q0)
      : heuristic_(std::move(heuristic)), weights_(heuristic_), alpha_(alpha), q0_(static_cast<float>(q0)) {}

  /// On cells that no trail has left all eight are alike and change nothing.
  void prepare(const Trail<MoveCells>& trail);

  LaneBits operator()(const GridStands& at, const LaneStreams& streams) const {
    MoveLanes weights = at.load(weights_);
    for (unsigned d = 0; d < kRow; ++d) weights[d] = keep(weights[d], at.left(d));
    const LaneBits drawn = pick(weights, draw_uniform(streams));
    if (q0_ == 0) return drawn;
    const LaneBits takes_best = (draw_uniform(streams) < q0_) | (drawn == kRow);
    return (heaviest(weights) & takes_best) | (drawn & ~takes_best);
  }

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;

  void rebuild(GridSpace::Cell cell, const StoredTrail* stored, const TrailLevels& levels);

  AlignedFloats heuristic_, weights_;
  int alpha_;
  float q0_;
};

}  // namespace alate
