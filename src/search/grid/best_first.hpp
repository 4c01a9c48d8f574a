// What A* and jump point search share: a query, its open list, and when it ends.
#pragma once

#include "alate/core/run_context.hpp"
#include "search/grid/bucket_queue.hpp"
#include "search/grid/cost_table.hpp"
#include "search/grid/grid_way.hpp"

namespace alate {

/// Made once for a map and asked many times: a query clears and allocates nothing. Not for two threads at once.
///
/// `Search` derives from it and brings `expand(entry)`, which comes to further places by `come_to`, and `trace(way)`,
/// which follows the costs back from the goal. An `Entry` has a key and a place; made of these two, it is the start.
///
/// Departure from A*: the open list is one of buckets, so a place may be expanded again after a better way to it turned
/// up in the same bucket; the search ends when no open place can lead to a shorter way.
template <class Search, class Entry>
class GridBestFirst {
 public:
  /// Between free cells of the map.
  GridWay find(GridPlace start, GridPlace goal, RunContext& run) {
    start_ = start;
    goal_ = goal;
    expansions_ = 0;
    costs_.begin_query();
    best_ = costs_.key(start == goal ? 0 : kMostOctileCost);
    costs_[grid_.cell(start)] = costs_.key(0);
    open_.clear(to_goal(start));
    open_.push(to_goal(start), Entry{costs_.key(0), start});
    GridWay way;
    way.finished = search(run);
    if (costs_.known(grid_.cell(goal))) self().trace(way);
    way.expansions = expansions_;
    return way;
  }

 protected:
  /// At a place by the best way known to it.
  void come_to(const Entry& entry) {
    const OctileCost rest = to_goal(entry.place);
    if (entry.key + rest >= best_) return;
    if (rest == 0) {
      best_ = entry.key;
    } else {
      open_.push(CostTable::cost(entry.key) + rest, entry);
    }
  }

  const BitGrid& grid_;
  CostTable costs_;
  GridPlace start_, goal_;

 private:
  friend Search;
  /// `grid` must outlive this. `spread`: of the costs that are open at one time.
  GridBestFirst(const BitGrid& grid, OctileCost spread) : grid_(grid), costs_(grid.by_row().cells()), open_(spread) {}

  Search& self() { return static_cast<Search&>(*this); }
  OctileCost to_goal(GridPlace place) const {
    return octile(int{place.column} - int{goal_.column}, int{place.row} - int{goal_.row});
  }

  /// False if the run was stopped.
  bool search(RunContext& run) {
    while (!open_.empty()) {
      const Entry entry = open_.pop();
      if (entry.key != costs_[grid_.cell(entry.place)] || entry.key + to_goal(entry.place) >= best_) continue;
      if (expansions_ % kPollEvery == 0 && !run.keep_going()) return false;
      ++expansions_;
      self().expand(entry);
    }
    return true;
  }

  BucketQueue<Entry> open_;
  CostTable::Key best_ = 0;  ///< Ways from here on are no better than the one known.
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
