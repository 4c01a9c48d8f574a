// What A* and jump point search share, in the plane and in space: a query, its open list, and when it ends.
#pragma once

#include "alate/core/run_context.hpp"
#include "search/grid/bucket_queue.hpp"
#include "search/grid/cost_table.hpp"
#include "search/grid/grid_way.hpp"

namespace alate {

/// What such a search needs to know of height grids.
struct OctileSpace {
  using Grid = BitGrid;
  using Place = GridPlace;
  using Way = GridWay;
  using Costs = CostTable;
  using Cost = OctileCost;
  static constexpr Cost kMostCost = kMostOctileCost;
  static constexpr unsigned kBucketBits = 24;
  static_assert((Cost{1} << kBucketBits) <= 2 * kStraight - kDiagonal, "the least amount by which a step raises f");

  static Cost distance(Place a, Place b) { return octile(int{a.column} - int{b.column}, int{a.row} - int{b.row}); }
};

/// Made once for a map and asked many times: a query clears and allocates nothing. Not for two threads at once.
///
/// `Search` derives from it and brings `expand(entry)`, which comes to further places by `come_to`, and `trace(way)`,
/// which follows the costs back from the goal. An `Entry` has a key and a place; made of these two, it is the start.
///
/// Departure from A*: the open list is one of buckets, so a place may be expanded again after a better way to it turned
/// up in the same bucket; the search ends when no open place can lead to a shorter way.
template <class Search, class Entry, class Space = OctileSpace>
class GridBestFirst {
 public:
  using Grid = typename Space::Grid;
  using Place = typename Space::Place;
  using Way = typename Space::Way;
  using Cost = typename Space::Cost;
  using Key = typename Space::Costs::Key;

  /// Between free cells of the map.
  Way find(Place start, Place goal, RunContext& run) {
    start_ = start;
    goal_ = goal;
    expansions_ = 0;
    costs_.begin_query();
    best_ = costs_.key(start == goal ? 0 : Space::kMostCost);
    costs_[grid_.cell(start)] = costs_.key(0);
    open_.clear(to_goal(start));
    open_.push(to_goal(start), Entry{costs_.key(0), start});
    Way way;
    way.finished = search(run);
    if (costs_.known(grid_.cell(goal))) self().trace(way);
    way.expansions = expansions_;
    return way;
  }

 protected:
  /// At a place by the best way known to it.
  void come_to(const Entry& entry) {
    const Cost rest = to_goal(entry.place);
    if (entry.key + rest >= best_) return;
    if (rest == 0) {
      best_ = entry.key;
    } else {
      open_.push(Space::Costs::cost(entry.key) + rest, entry);
    }
  }
  /// Comes back to `entry` when the ways through it cost `rest` from it on, or more.
  void put_off(const Entry& entry, Cost rest) {
    if (entry.key + rest < best_) open_.push(Space::Costs::cost(entry.key) + rest, entry);
  }
  Cost to_goal(Place place) const { return Space::distance(place, goal_); }
  /// The highest f of the bucket that is looked at.
  Cost open_level() const { return open_.least() | ((Cost{1} << Space::kBucketBits) - 1); }
  bool is_too_dear(Key key) const { return key >= best_; }

  const Grid& grid_;
  typename Space::Costs costs_;
  Place start_, goal_;

 private:
  friend Search;
  /// `grid` must outlive this. `spread`: of the costs that are open at one time.
  GridBestFirst(const Grid& grid, Cost spread) : grid_(grid), costs_(grid.cells()), open_(spread) {}

  Search& self() { return static_cast<Search&>(*this); }

  /// False if the run was stopped.
  bool search(RunContext& run) {
    while (!open_.empty()) {
      const Entry entry = open_.pop();
      if (costs_.key(open_.least()) >= best_) return true;
      if (entry.key != costs_[grid_.cell(entry.place)] || entry.key + to_goal(entry.place) >= best_) continue;
      if (expansions_ % kPollEvery == 0 && !run.keep_going()) return false;
      ++expansions_;
      self().expand(entry);
    }
    return true;
  }

  BucketQueue<Entry, Space::kBucketBits> open_;
  Key best_ = 0;  ///< Ways from here on are no better than the one known.
  std::uint64_t expansions_ = 0;
};

}  // namespace alate
