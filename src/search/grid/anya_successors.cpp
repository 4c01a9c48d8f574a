// What follows from a cone: cones through the next row, and those that begin at the corners that it passes.
#include "search/grid/anya.hpp"
#include "search/grid/wall_ends.hpp"

namespace alate {

/// A straight line to the goal, which lies in the run that the cone enters.
void Anya::look_for_goal(const Cone& cone, Rays rays) {
  const double rows = cone.depth() + 0.5;
  const double across = goal_.x - cone.root.at.x;
  if (across < rays.left * rows || across > rays.right * rows) return;
  const double length = cone.root.length + distance(cone.root.at, goal_);
  if (length >= best_) return;
  best_ = length;
  last_ = cone.root;
}

/// Between two rays of a cone through a free run, and on to the next row.
void Anya::enter(const Cone& cone, Rays rays, FreeRun run) {
  if (cone.row == goal_row_ && goal_column_ >= run.left && goal_column_ < run.right) look_for_goal(cone, rays);
  const double x = cone.root.at.x;
  const double rows = cone.depth() + 1;
  if (x + rays.left * rows < run.left) rays.left = (run.left - x) / rows;
  if (x + rays.right * rows > run.right) rays.right = (run.right - x) / rows;
  if (!(rays.left < rays.right)) return;
  const Cone next{cone.root, rays, cone.row + cone.down, cone.down};
  const double least = next.least_length(goal_);
  if (least < best_) open_.push(priority(least), {next, least});
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
  enter(next, side == Side::left ? Rays{0, ray} : Rays{ray, 0}, run);
}

/// Round the blocked cell beside the row that the cone comes from.
void Anya::turn_outwards(const Cone& cone, FreeRun run, Side side, double x) {
  Cone next = cone;
  if (!turn(cone.root, static_cast<int>(x), static_cast<int>(cone.line()), next.root)) return;
  enter(next, side == Side::left ? Rays{-Rays::kWide, cone.rays.left} : Rays{cone.rays.right, Rays::kWide}, run);
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
    const RowScan row(grid_, next.row);
    if (ahead) {
      enter(next, {0, Rays::kWide}, row.run_from(corner));
    } else {
      enter(next, {-Rays::kWide, 0}, row.run_until(corner));
    }
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
  Rays seen = cone.rays;
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
  enter(cone, seen, run);
}

void Anya::expand(const Cone& cone) {
  const double rows = cone.depth();
  const double left = cone.meets(cone.rays.left, rows);
  const double right = cone.meets(cone.rays.right, rows);
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

}  // namespace alate
