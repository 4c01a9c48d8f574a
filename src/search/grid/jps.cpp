#include "search/grid/jps.hpp"

#include <algorithm>

#include "search/grid/directions.hpp"
#include "search/grid/straight_run.hpp"

namespace alate {

JumpPointSearch::JumpPointSearch(const BitGrid& grid)
    : GridBestFirst(grid, widest_spread(grid)), parents_(grid.by_row().cells()), entered_(grid.by_row().cells()) {}

void JumpPointSearch::reach(const Origin& origin, GridPlace place, unsigned direction) {
  const BitGrid::Cell cell = grid_.cell(place);
  if (origin.key > costs_[cell]) return;
  const auto side = static_cast<std::uint8_t>(1U << direction);
  if (origin.key < costs_[cell]) {
    costs_[cell] = origin.key;
    parents_[cell] = origin.parent;
    entered_[cell] = side;
  } else {
    if ((entered_[cell] & side) != 0) return;
    entered_[cell] |= side;
  }
  come_to({origin.key, place, direction});
}

void JumpPointSearch::run_straight(const Origin& origin, unsigned direction) {
  const StraightRun run = run_in(grid_, origin.place, direction);
  unsigned steps = run.turns ? run.steps : 0;
  const int goal = steps_to(origin.place, goal_, direction);
  if (goal > 0 && goal <= static_cast<int>(run.steps)) steps = static_cast<unsigned>(goal);
  if (steps == 0) return;
  reach({origin.key + steps * kStraight, origin.place, origin.parent},
        moved(origin.place, direction, static_cast<int>(steps)), direction);
}

void JumpPointSearch::run_diagonally(Origin origin, unsigned direction) {
  const unsigned before = turned(direction, 7);
  const unsigned after = turned(direction, 1);
  while (((grid_.moves(grid_.cell(origin.place)) >> direction) & 1U) != 0) {
    origin.place = moved(origin.place, direction);
    origin.key += kDiagonal;
    if (origin.place == goal_) return reach(origin, goal_, direction);
    run_straight(origin, before);
    run_straight(origin, after);
  }
}

/// Beside a wall that has just ended the way may turn, straight or diagonally.
void JumpPointSearch::turn(const Origin& origin, unsigned direction, bool left) {
  const unsigned straight = turned(direction, left ? 2 : 6);
  const GridPlace behind = moved(moved(origin.place, straight), turned(direction, 4));
  if (grid_.is_free(behind) || !grid_.is_free(moved(origin.place, straight))) return;
  run_straight(origin, straight);
  run_diagonally(origin, turned(direction, left ? 1 : 7));
}

void JumpPointSearch::expand(const JumpPoint& entry) {
  const Origin origin{entry.key, entry.place, entry.place};
  if (entry.direction == JumpPoint::kNoDirection) {
    for (unsigned d = 0; d < BitGrid::kDirections; d += 2) run_straight(origin, d);
    for (unsigned d = 1; d < BitGrid::kDirections; d += 2) run_diagonally(origin, d);
    return;
  }
  run_straight(origin, entry.direction);
  turn(origin, entry.direction, true);
  turn(origin, entry.direction, false);
}

/// Between two jump points a way runs diagonally first.
void JumpPointSearch::trace(GridWay& way) const {
  way.found = true;
  std::vector<GridPlace> points{goal_};
  while (points.back() != start_) points.push_back(parents_[grid_.cell(points.back())]);
  std::ranges::reverse(points);
  add_corner(way, start_);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const GridPlace from = points[i - 1];
    const int across = int{points[i].column} - int{from.column};
    const int along = int{points[i].row} - int{from.row};
    const int both = std::min(std::abs(across), std::abs(along));
    const auto shifted = [both](int at, int by) { return static_cast<std::uint16_t>(at + (by > 0 ? both : -both)); };
    add_corner(way, {shifted(from.column, across), shifted(from.row, along)});
    add_corner(way, points[i]);
  }
}

}  // namespace alate
