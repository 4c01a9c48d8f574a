// Trails on directed moves of a grid: a row of eight levels for each cell.
//
// Source: Yin et al. 2021, eqs. (7)-(9): pheromone lies on the move (cell, direction) and is not made symmetric [C].
#pragma once

#include <span>
#include <vector>

#include "aco/ant.hpp"
#include "aco/pheromone/levels.hpp"
#include "space/height_grid.hpp"

namespace alate {

class MoveCells {
 public:
  static constexpr std::size_t kRow = GridSpace::kDirections;

  explicit MoveCells(std::size_t cells) : stored_(kRow * cells), is_known_(cells) {}

  static TrailKey key(GridSpace::Cell cell, unsigned direction) { return TrailKey{cell} * kRow + direction; }

  StoredTrail find(TrailKey move) const { return stored_[move]; }
  StoredTrail& at(TrailKey move) {
    const auto cell = static_cast<GridSpace::Cell>(move / kRow);
    if (is_known_[cell] == 0) known_.push_back(cell);
    is_known_[cell] = 1;
    return stored_[move];
  }
  template <class Change>
  void for_each(const Change& change) {
    for (const GridSpace::Cell cell : known_)
      for (StoredTrail& one : std::span(&stored_[kRow * cell], kRow))
        if (one != 0) change(one);
  }

  /// The eight trails that leave a cell.
  const StoredTrail* row(GridSpace::Cell cell) const { return &stored_[kRow * cell]; }
  /// Cells that some trail has left. On all others the eight trails are alike.
  const std::vector<GridSpace::Cell>& known_cells() const { return known_; }

 private:
  AlignedFloats stored_;
  std::vector<std::uint8_t> is_known_;
  std::vector<GridSpace::Cell> known_;
};

}  // namespace alate
