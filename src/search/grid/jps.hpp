// Jump point search.
#pragma once

#include "alate/core/run_context.hpp"
#include "search/grid/bucket_queue.hpp"
#include "search/grid/cost_table.hpp"
#include "search/grid/grid_way.hpp"

namespace alate {

/// Jump point search (Harabor and Grastien 2011) without corner cutting: of all equally short ways only those that go
/// diagonally first are followed, and only cells where such a way may have to turn round an obstacle are kept. Straight
/// runs are read 56 cells at a time from three lanes of bits, and the cells at which a diagonal run branches off are
/// passed over (JPS (B + P), Harabor and Grastien 2014). Nothing is worked out beforehand but the bits. Made once for a
/// map and asked many times: a query clears and allocates nothing. Not for two threads at once.
///
/// Departure: a cell that is reached at the same cost from several sides is expanded once for each side, so that the
/// proof needs no order among equals.
class JumpPointSearch {
 public:
  /// `grid` must outlive this.
  explicit JumpPointSearch(const BitGrid& grid);

  /// Between free cells of the map.
  GridWay find(GridPlace start, GridPlace goal, RunContext& run);

 private:
  /// A jump point, and the straight direction in which it was entered.
  struct Entry {
    CostTable::Key key;
    GridPlace place;
    unsigned direction;
  };
  /// Where a run begins, and the jump point that the way turned at last.
  struct Origin {
    CostTable::Key key;
    GridPlace place;
    GridPlace parent;
  };

  bool search(RunContext& run);
  void expand(const Entry& entry);
  void turn(const Origin& origin, unsigned direction, bool left);
  void run_straight(const Origin& origin, unsigned direction);
  void run_diagonally(Origin origin, unsigned direction);
  void reach(const Origin& origin, GridPlace place, unsigned direction);
  void trace(GridWay& way) const;
  OctileCost to_goal(GridPlace place) const {
    return octile(int{place.column} - int{goal_.column}, int{place.row} - int{goal_.row});
  }

  const BitGrid& grid_;
  CostTable costs_;
  std::vector<GridPlace> parents_;
  std::vector<std::uint8_t> entered_;  ///< Bit d: entered in direction d at the least cost.
  BucketQueue<Entry> open_;
  GridPlace start_, goal_;
  CostTable::Key best_ = 0;  ///< Ways from here on are no better than the one known.
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
