#include "search/grid/anya.hpp"

#include <algorithm>

#include "search/grid/grid_way.hpp"
#include "search/grid/wall_ends.hpp"

namespace alate {

namespace {

GridPoint middle(GridPlace place) { return {place.column + 0.5, place.row + 0.5}; }

OctileCost priority(double length) { return static_cast<OctileCost>(length * static_cast<double>(kStraight)); }

}  // namespace

Anya::Anya(const BitGrid& grid) : grid_(grid), labels_(grid.by_row().cells()), open_(widest_spread(grid)) {}

/// A straight line to the goal, if it lies in the run that the cone enters.
void Anya::look_for_goal(const Cone& cone, FreeRun run) {
  if (cone.row != goal_row_ || goal_column_ < run.left || goal_column_ >= run.right) return;
  const double rows = cone.depth() + 0.5;
  const double across = goal_.x - cone.root.at.x;
  if (!(across >= cone.left * rows && across <= cone.right * rows)) return;
  const double length = cone.root.length + distance(cone.root.at, goal_);
  if (length >= best_) return;
  best_ = length;
  last_ = cone.root;
}

/// Through a free run, and on to the next row.
void Anya::enter(Cone cone, FreeRun run) {
  look_for_goal(cone, run);
  const double x = cone.root.at.x;
  const double rows = cone.depth() + 1;
  if (x + cone.left * rows < run.left) cone.left = (run.left - x) / rows;
  if (x + cone.right * rows > run.right) cone.right = (run.right - x) / rows;
  if (!(cone.left < cone.right)) return;
  cone.row += cone.down;
  const double least = cone.least_length(goal_);
  if (least < best_) open_.push(priority(least), {cone, least});
}

/// Is the way from a root the shortest to a corner known so far? Then it may turn there. Of two equally short ways one
/// is enough: a way that goes on from the other and would not be taut behind this one is not the shortest.
bool Anya::turn(const Root& from, int x, int y, Root& root) {
  root.at = {static_cast<double>(x), static_cast<double>(y)};
  root.length = from.length + distance(from.at, root.at);
  root.corner = grid_.by_row().cell(static_cast<unsigned>(x), static_cast<unsigned>(y));
  if (root.length > labels_.length(root.corner) - kTie) return false;
  if (root.length + distance(root.at, goal_) >= best_) return false;
  labels_.set(root.corner, root.length, from.corner);
  return true;
}

/// Round the blocked cell at the end of the run, behind which the cone does not see.
void Anya::turn_inwards(const Cone& cone, FreeRun run, Side side, double ray) {
  Cone next = cone;
  if (!turn(cone.root, side == Side::left ? run.left : run.right, static_cast<int>(cone.line()), next.root)) return;
  next.left = side == Side::left ? 0 : ray;
  next.right = side == Side::left ? ray : 0;
  enter(next, run);
}

/// Round the blocked cell beside the row that the cone comes from.
void Anya::turn_outwards(const Cone& cone, FreeRun run, Side side, double x) {
  Cone next = cone;
  if (!turn(cone.root, static_cast<int>(x), static_cast<int>(cone.line()), next.root)) return;
  if (side == Side::left) {
    next.left = -Cone::kWide;
    next.right = cone.left;
  } else {
    next.left = cone.right;
    next.right = Cone::kWide;
  }
  enter(next, run);
  run_along(next.root, cone, side);
}

/// Along the line by which the cone enters its row, turning wherever a wall beside it ends.
void Anya::run_along(const Root& from, const Cone& cone, Side side) {
  const bool ahead = side == Side::right;
  const auto x = static_cast<int>(from.at.x);
  const BitLanes& lanes = grid_.by_row();
  const auto begin = static_cast<unsigned>(ahead ? x - 1 : x);
  const auto beyond = lanes.cell(begin, static_cast<unsigned>(cone.row));
  const auto before = lanes.cell(begin, static_cast<unsigned>(cone.row - cone.down));
  const auto turn_at = [&](int steps, bool is_beyond) {
    Cone next = cone;
    if (!is_beyond) {
      next.row -= cone.down;
      next.down = -cone.down;
    }
    const int corner = ahead ? x + steps : x - steps;
    if (!turn(from, corner, static_cast<int>(from.at.y), next.root)) return;
    next.left = ahead ? 0 : -Cone::kWide;
    next.right = ahead ? Cone::kWide : 0;
    const RowScan scan(grid_, next.row);
    enter(next, ahead ? scan.run_from(corner) : scan.run_until(corner));
  };
  if (ahead) {
    wall_ends<true>(lanes, beyond, before, turn_at);
  } else {
    wall_ends<false>(lanes, beyond, before, turn_at);
  }
}

/// Through one free run of the row, of which the cone covers what lies between two grid coordinates.
void Anya::pass(const Cone& cone, FreeRun run, double left, double right) {
  const double rows = cone.depth();
  const RowScan behind(grid_, cone.row - cone.down);
  Cone seen = cone;
  if (run.left >= left) {
    if (run.left > left) seen.left = (run.left - cone.root.at.x) / rows;
    if (seen.left > 0) turn_inwards(cone, run, Side::left, seen.left);
  } else if (const auto x = static_cast<int>(left); x == left && behind.is_blocked(x - 1)) {
    turn_outwards(cone, run, Side::left, left);
  }
  if (run.right <= right) {
    if (run.right < right) seen.right = (run.right - cone.root.at.x) / rows;
    if (seen.right < 0) turn_inwards(cone, run, Side::right, seen.right);
  } else if (const auto x = static_cast<int>(right); x == right && behind.is_blocked(x)) {
    turn_outwards(cone, run, Side::right, right);
  }
  enter(seen, run);
}

void Anya::expand(const Cone& cone) {
  const double rows = cone.depth();
  const double left = cone.meets(cone.left, rows);
  const double right = cone.meets(cone.right, rows);
  const RowScan row(grid_, cone.row);
  const auto first = static_cast<int>(left);
  for (int x = first; x < right;) {
    x = row.next_free(x, static_cast<int>(right) + 1);
    if (x >= right) break;
    const FreeRun run = x == first ? row.run_around(x) : row.run_from(x);
    pass(cone, run, left, right);
    x = run.right + 1;
  }
}

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
  for (Corner corner = last_.corner; corner != kStart; corner = labels_.parent(corner))
    way.points.push_back({static_cast<double>(corner % stride), static_cast<double>(corner / stride)});
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
  for (const int down : {1, -1}) enter({.root = root, .row = start.row, .down = down}, around);
  AnyAngleWay way;
  way.finished = search(run);
  if (best_ < std::numeric_limits<double>::infinity()) trace(way);
  way.expansions = expansions_;
  return way;
}

}  // namespace alate
