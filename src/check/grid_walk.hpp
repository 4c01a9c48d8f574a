// Which cells of a grid a straight flight passes, exactly, independent of the planners' spaces.
#pragma once

#include <array>
#include <vector>

#include "alate/data/height_grid.hpp"

namespace alate {

struct GridCell {
  int column = 0;
  int row = 0;

  bool operator==(const GridCell&) const = default;
};

/// Flight between two grid lines. It lies in one cell, or along the common side of two; a flight of no length may lie
/// on the common corner of four. Cells may be outside the grid.
struct Stretch {
  std::array<GridCell, 4> cells;
  std::size_t count = 0;
  Vec2 begin = Vec2::Zero();
  Vec2 middle = Vec2::Zero();
};

/// Follows a route over `grid`. Steps within kRoundingNoise of where it stands are joined to the next one, so that a
/// chain of them hides nothing. Places within kRoundingNoise of a grid line lie on it.
class GridPassage {
 public:
  GridPassage(const HeightGrid& grid, const Vec2& start) : grid_(grid), at_(start - grid.origin) {}

  /// The stretches of the straight flight to `place`, in order; parts more than a cell outside the grid left out. At
  /// most columns + rows + 5 of them.
  std::vector<Stretch> advance(const Vec2& place);
  /// Where it stands.
  Stretch here() const { return stretch(at_, at_); }

 private:
  /// Between places counted from the grid's origin.
  Stretch stretch(const Vec2& begin, const Vec2& end) const;

  const HeightGrid& grid_;
  Vec2 at_;  ///< From the grid's origin.
};

/// A free cell of the stretch; nothing if none is.
const GridCell* free_cell(const HeightGrid& grid, const Stretch& stretch);

/// Does the stretch lie in blocked cells of the grid only?
bool is_blocked(const HeightGrid& grid, const Stretch& stretch);

/// May flight go on from one stretch to the next, where they touch: from a free cell to itself, to a free neighbour
/// across a side, or across a corner if the two cells beside it are free as well (no corner cutting: Yin et al. 2021,
/// Sturtevant 2012).
bool connects(const HeightGrid& grid, const Stretch& from, const Stretch& to);

}  // namespace alate
