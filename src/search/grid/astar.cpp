#include "search/grid/astar.hpp"

#include <algorithm>

#include "search/grid/directions.hpp"

namespace alate {

namespace {

constexpr OctileCost step(unsigned direction) { return direction % 2 == 0 ? kStraight : kDiagonal; }

}  // namespace

GridAStar::GridAStar(const BitGrid& grid) : GridBestFirst(grid, 2 * kDiagonal) {
  std::ranges::transform(kGridShifts, offsets_.begin(), [&](const std::array<int, 2>& shift) {
    return static_cast<Cell>(shift[0]) + static_cast<Cell>(shift[1]) * grid.by_row().stride();
  });
}

void GridAStar::expand(const AStarEntry& entry) {
  const Cell cell = grid_.cell(entry.place);
  for (unsigned free = grid_.moves(cell); free != 0; free &= free - 1) {
    const auto d = static_cast<unsigned>(std::countr_zero(free));
    const Cell next = cell + offsets_[d];
    const CostTable::Key key = entry.key + step(d);
    if (key >= costs_[next]) continue;
    costs_[next] = key;
    come_to({key, moved(entry.place, d)});
  }
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

}  // namespace alate
