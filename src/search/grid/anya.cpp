#include "search/grid/anya.hpp"

#include <algorithm>

#include "search/grid/grid_way.hpp"

namespace alate {

namespace {

GridPoint middle(GridPlace place) { return {place.column + 0.5, place.row + 0.5}; }

}  // namespace

Anya::Anya(const BitGrid& grid) : grid_(grid), labels_(grid.by_row().cells()), open_(widest_spread(grid)) {}

/// False if the run was stopped.
bool Anya::search(RunContext& run) {
  while (!open_.empty()) {
    const Entry entry = open_.pop();
    if (entry.least >= best_ || entry.cone.root.length > labels_.length(entry.cone.root.corner)) continue;
    if (expansions_ % kPollEvery == 0 && !run.keep_going()) return false;
    ++expansions_;
    expand(entry.cone);
  }
  return true;
}

void Anya::trace(AnyAngleWay& way) const {
  const Corner stride = grid_.by_row().stride();
  way.found = true;
  way.length = best_;
  way.points.push_back(goal_);
  for (Corner corner = last_.corner; corner != kStart; corner = labels_.parent(corner)) {
    const Corner row = corner / stride;
    way.points.push_back({static_cast<double>(corner % stride), static_cast<double>(row)});
  }
  if (start_ != goal_) way.points.push_back(start_);
  std::ranges::reverse(way.points);
}

AnyAngleWay Anya::find(GridPlace start, GridPlace goal, RunContext& run) {
  start_ = middle(start);
  goal_ = middle(goal);
  goal_row_ = goal.row;
  goal_column_ = goal.column;
  expansions_ = 0;
  best_ = std::numeric_limits<double>::infinity();
  labels_.begin_query();
  labels_.set(kStart, 0, kStart);
  const Root root{start_, 0, kStart};
  const double straight = distance(start_, goal_);
  open_.clear(priority(straight));
  const FreeRun around = RowScan(grid_, start.row).run_around(start.column);
  if (goal.row == start.row && goal.column >= around.left && goal.column < around.right) {
    best_ = straight;
    last_ = root;
  }
  for (const int down : {1, -1}) enter({.root = root, .row = start.row, .down = down}, {}, around);
  AnyAngleWay way;
  way.finished = search(run);
  if (best_ < std::numeric_limits<double>::infinity()) trace(way);
  way.expansions = expansions_;
  return way;
}

}  // namespace alate
