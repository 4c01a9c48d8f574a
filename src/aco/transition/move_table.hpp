// Moves drawn from a table: for each cell the eight weights tau^alpha eta^beta, built again where trails have changed.
//
// Random proportional rule (Dorigo, Maniezzo, Colorni 1996, eq. (4)); with chance q0 the heaviest move instead (Dorigo,
// Gambardella 1997, eq. (3)). A draw masks the visited neighbours, sums and compares eight weights side by side,
// without a branch that depends on chance: each would cost more than all of that.
#pragma once

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/transition/octet.hpp"
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
    const Octet weights = OctetMask::of(~at.tabu).keep(Octet::load(&weights_[kRow * at.cell]));
    if (q0_ > 0) return draw_or_best(weights, stream);
    const unsigned direction = draw(weights, stream.uniform_float());
    return direction < kRow ? direction : heaviest(weights);  // all 0, or too little to be divided
  }

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;

  /// Both are worked out: chance decides which counts, and no processor could foresee it.
  unsigned draw_or_best(const Octet& weights, Stream& stream) const {
    const bool takes_best = stream.uniform_float() < q0_;
    const unsigned drawn = draw(weights, stream.uniform_float());
    const unsigned best = heaviest(weights);
    return takes_best || drawn == kRow ? best : drawn;
  }
  void rebuild(GridSpace::Cell cell, const Trail<MoveCells>& trail);

  AlignedFloats heuristic_, weights_;
  int alpha_;
  float q0_;
};

}  // namespace alate
