#include "search/grid/grid_way.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace alate {

namespace {

std::array<int, 2> difference(GridPlace from, GridPlace to) {
  return {int{to.column} - int{from.column}, int{to.row} - int{from.row}};
}

int sign(int value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }

bool same_direction(std::array<int, 2> a, std::array<int, 2> b) {
  return sign(a[0]) == sign(b[0]) && sign(a[1]) == sign(b[1]);
}

}  // namespace

void add_corner(GridWay& way, GridPlace place) {
  std::vector<GridPlace>& corners = way.corners;
  if (!corners.empty()) {
    if (corners.back() == place) return;
    const auto run = difference(corners.back(), place);
    (run[0] == 0 || run[1] == 0 ? way.length.straights : way.length.diagonals) +=
        std::max(std::abs(run[0]), std::abs(run[1]));
    if (corners.size() > 1 && same_direction(difference(corners[corners.size() - 2], corners.back()), run))
      corners.pop_back();
  }
  corners.push_back(place);
}

}  // namespace alate
