// A* from cell to cell.
#pragma once

#include <array>

#include "search/grid/best_first.hpp"

namespace alate {

struct AStarEntry {
  CostTable::Key key = 0;
  GridPlace place;
};

/// A* (Hart, Nilsson and Raphael 1968) with the octile heuristic, eight moves, no corner cutting.
class GridAStar : public GridBestFirst<GridAStar, AStarEntry> {
 public:
  /// `grid` must outlive this.
  explicit GridAStar(const BitGrid& grid);

 private:
  friend class GridBestFirst;
  using Cell = BitGrid::Cell;

  void expand(const AStarEntry& entry);
  void trace(GridWay& way) const;

  std::array<Cell, BitGrid::kDirections> offsets_{};  ///< To the neighbours; sums wrap round.
};

}  // namespace alate
