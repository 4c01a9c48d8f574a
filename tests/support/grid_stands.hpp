// Four ants at the same place, for tests of choices.
#pragma once

#include "aco/walk/lanes.hpp"

namespace alate::test {

struct Place {
  GridSpace::Cell cell = 0;
  unsigned came = GridSpace::kNoDirection;
  unsigned tabu = 0;  ///< Bit d: the neighbour in direction d has been visited.
};

inline GridStands stands_at(const Place& place) {
  constexpr std::int32_t kMark = 7;
  GridStands at;
  at.cell.fill(place.cell);
  at.came.fill(place.came);
  at.mark += kMark * 0x01010101;
  for (unsigned d = 0; d < GridSpace::kDirections; ++d) {
    const auto [across, along] = GridSpace::shift(d);
    const std::int32_t mark = ((place.tabu >> d) & 1U) != 0 ? kMark : kMark + 1;
    const auto row = static_cast<std::size_t>(along) + 1;  // north first: -1 wraps round to 0
    at.marks[row] |= mark << (8 * (across + 1));
  }
  return at;
}

}  // namespace alate::test
