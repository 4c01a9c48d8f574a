// A* from cell to cell.
#pragma once

#include "alate/core/run_context.hpp"
#include "search/grid/bucket_queue.hpp"
#include "search/grid/cost_table.hpp"
#include "search/grid/grid_way.hpp"

namespace alate {

/// A* (Hart, Nilsson and Raphael 1968) with the octile heuristic, eight moves, no corner cutting. Made once for a map
/// and asked many times: a query clears and allocates nothing. Not for two threads at once.
///
/// Departure: the open list is one of buckets, so a cell may be expanded again after a better way to it turned up in
/// the same bucket; the search ends when no open cell can lead to a shorter way.
class GridAStar {
 public:
  /// `grid` must outlive this.
  explicit GridAStar(const BitGrid& grid);

  /// Between free cells of the map.
  GridWay find(GridPlace start, GridPlace goal, RunContext& run);

 private:
  using Cell = BitGrid::Cell;
  struct Entry {
    CostTable::Key key;
    GridPlace place;
  };

  bool search(RunContext& run);
  void expand(const Entry& entry);
  void trace(GridWay& way) const;
  OctileCost to_goal(GridPlace place) const {
    return octile(int{place.column} - int{goal_.column}, int{place.row} - int{goal_.row});
  }

  const BitGrid& grid_;
  std::array<Cell, BitGrid::kDirections> offsets_{};  ///< To the neighbours; sums wrap round.
  CostTable costs_;
  BucketQueue<Entry> open_;
  GridPlace start_, goal_;
  CostTable::Key best_ = 0;  ///< Ways from here on are no better than the one known.
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
