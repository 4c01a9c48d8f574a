// Moves drawn from tables: for each cell the running sums of tau^alpha eta^beta over its eight moves.
//
// Random proportional rule (Dorigo, Maniezzo, Colorni 1996, eq. (4)); with chance q0 the heaviest move instead (Dorigo,
// Gambardella 1997, eq. (3)). The sums know nothing of visited cells: a draw that hits one is drawn again among the
// others, which gives the same chances. Trails change once an iteration, and so do the tables, on cells that carry one.
#pragma once

#include "aco/pheromone/move_cells.hpp"
#include "aco/pheromone/trail.hpp"
#include "aco/walk/grid_walk.hpp"
#include "alate/core/stream.hpp"

namespace alate {

class MoveTable {
 public:
  /// `heuristic`: eta^beta of every move by cell, as GridSpace numbers them; 0 where it is not free.
  MoveTable(const GridSpace& space, AlignedFloats heuristic, int alpha, double q0);

  void prepare(const Trail<MoveCells>& trail);

  unsigned operator()(const GridStand& at, Stream& stream) const {
    const float uniform = drawn(stream);
    if (uniform < q0_) return greedy(at);
    const unsigned direction = look_up(at.cell, (uniform - q0_) * per_rest_);
    const auto to = at.cell + static_cast<GridSpace::Cell>(offsets_[direction]);
    return at.visited[to] == 0 ? direction : among_unvisited(at, stream);
  }

  /// Not normalised, eight a cell.
  const AlignedFloats& weights() const { return weights_; }

 private:
  static constexpr std::size_t kRow = MoveCells::kRow;

  /// In [0, 1), 24 bits.
  static float drawn(Stream& stream) {
    return static_cast<float>(static_cast<std::int32_t>(stream.bits() >> 40U)) * 0x1.0p-24F;
  }
  /// How many of the sums are at most `uniform`; the sum of the last free move is above any.
  unsigned look_up(GridSpace::Cell cell, float uniform) const {
    const float* until = &until_[kRow * cell];
    unsigned direction = until[3] <= uniform ? 4 : 0;
    direction += until[direction + 1] <= uniform ? 2 : 0;
    return direction + (until[direction] <= uniform ? 1 : 0);
  }
  unsigned greedy(const GridStand& at) const;
  unsigned among_unvisited(const GridStand& at, Stream& stream) const;
  void rebuild(GridSpace::Cell cell, const Trail<MoveCells>& trail);

  const GridSpace& space_;
  std::array<std::int32_t, kRow> offsets_;
  AlignedFloats heuristic_, weights_, until_;
  int alpha_;
  float q0_;
  float per_rest_;
  bool prepared_ = false;
};

}  // namespace alate
