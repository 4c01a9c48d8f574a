#include "search/grid_distance.hpp"

#include <bit>
#include <functional>
#include <queue>
#include <utility>

namespace alate {

std::vector<double> grid_distances(const GridSpace& space, GridSpace::Cell from) {
  using Entry = std::pair<double, GridSpace::Cell>;
  std::vector<double> lengths(space.cells(), kInfinity);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  lengths[from] = 0;
  open.emplace(0, from);
  while (!open.empty()) {
    const auto [length, cell] = open.top();
    open.pop();
    if (length > lengths[cell]) continue;  // A shorter way to it has been found since.
    for (unsigned free = space.open(cell); free != 0; free &= free - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(free));
      const GridSpace::Cell next = space.neighbour(cell, direction);
      const double until = length + space.step(direction);
      if (!(until < lengths[next])) continue;
      lengths[next] = until;
      open.emplace(until, next);
    }
  }
  return lengths;
}

}  // namespace alate
