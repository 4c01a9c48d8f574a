#include "search/grid/astar.hpp"

#include <algorithm>

#include "search/grid/directions.hpp"

namespace alate {

namespace {

constexpr OctileCost step(unsigned direction) { return direction % 2 == 0 ? kStraight : kDiagonal; }

}  // namespace

GridAStar::GridAStar(const BitGrid& grid) : grid_(grid), costs_(grid.by_row().cells()), open_(2 * kDiagonal) {
  std::ranges::transform(kGridShifts, offsets_.begin(), [&](const std::array<int, 2>& shift) {
    return static_cast<Cell>(shift[0]) + static_cast<Cell>(shift[1]) * grid.by_row().stride();
  });
}

void GridAStar::expand(const Entry& entry) {
  ++expansions_;
  const Cell cell = grid_.cell(entry.place);
  for (unsigned free = grid_.moves(cell); free != 0; free &= free - 1) {
    const auto d = static_cast<unsigned>(std::countr_zero(free));
    const Cell next = cell + offsets_[d];
    const CostTable::Key key = entry.key + step(d);
    if (key >= costs_[next]) continue;
    costs_[next] = key;
    const GridPlace place = moved(entry.place, d);
    const OctileCost rest = to_goal(place);
    if (key + rest >= best_) continue;
    if (rest == 0) {
      best_ = key;
    } else {
      open_.push(CostTable::cost(key) + rest, {key, place});
    }
  }
}

/// False if the run was stopped.
bool GridAStar::search(RunContext& run) {
  while (!open_.empty()) {
    const Entry entry = open_.pop();
    if (entry.key != costs_[grid_.cell(entry.place)] || entry.key + to_goal(entry.place) >= best_) continue;
    if (expansions_ % kPollEvery == 0 && !run.keep_going()) return false;
    expand(entry);
  }
  return true;
}

/// Back along steps whose costs add up, in one direction as long as they do.
void GridAStar::trace(GridWay& way) const {
  way.found = true;
  add_corner(way, goal_);
  unsigned d = 0;
  for (GridPlace at = goal_; at != start_; at = moved(at, d)) {
    const Cell cell = grid_.cell(at);
    const unsigned free = grid_.moves(cell);
    const auto leads_back = [&](unsigned direction) {
      return ((free >> direction) & 1U) != 0 && costs_[cell + offsets_[direction]] + step(direction) == costs_[cell];
    };
    for (unsigned turn = 0; !leads_back(d) && turn < BitGrid::kDirections; ++turn) d = (d + 1) % BitGrid::kDirections;
    add_corner(way, moved(at, d));
  }
  std::ranges::reverse(way.corners);
}

GridWay GridAStar::find(GridPlace start, GridPlace goal, RunContext& run) {
  start_ = start;
  goal_ = goal;
  expansions_ = 0;
  costs_.begin_query();
  best_ = costs_.key(start == goal ? 0 : kMostOctileCost);
  costs_[grid_.cell(start)] = costs_.key(0);
  open_.clear(to_goal(start));
  open_.push(to_goal(start), {costs_.key(0), start});
  GridWay way;
  way.finished = search(run);
  if (costs_.known(grid_.cell(goal))) trace(way);
  way.expansions = expansions_;
  return way;
}

}  // namespace alate
