// Jump point search.
#pragma once

#include <vector>

#include "search/grid/best_first.hpp"

namespace alate {

/// A jump point, and the straight direction in which it was entered.
struct JumpPoint {
  static constexpr unsigned kNoDirection = BitGrid::kDirections;

  CostTable::Key key = 0;
  GridPlace place;
  unsigned direction = kNoDirection;
};

/// Jump point search (Harabor and Grastien 2011) without corner cutting: of all equally short ways only those that go
/// diagonally first are followed, and only cells where such a way may have to turn round an obstacle are kept. Straight
/// runs are read 56 cells at a time from three lanes of bits, and the cells at which a diagonal run branches off are
/// passed over (JPS (B + P), Harabor and Grastien 2014). Nothing is worked out beforehand but the bits.
///
/// Departure: a cell that is reached at the same cost from several sides is expanded once for each side, so that the
/// proof needs no order among equals.
class JumpPointSearch : public GridBestFirst<JumpPointSearch, JumpPoint> {
 public:
  /// `grid` must outlive this.
  explicit JumpPointSearch(const BitGrid& grid);

 private:
  friend class GridBestFirst;

  /// Where a run begins, and the jump point that the way turned at last.
  struct Origin {
    CostTable::Key key = 0;
    GridPlace place;
    GridPlace parent;
  };

  void expand(const JumpPoint& entry);
  void turn(const Origin& origin, unsigned direction, bool left);
  void run_straight(const Origin& origin, unsigned direction);
  void run_diagonally(Origin origin, unsigned direction);
  void reach(const Origin& origin, GridPlace place, unsigned direction);
  void trace(GridWay& way) const;

  std::vector<GridPlace> parents_;
  std::vector<std::uint8_t> entered_;  ///< Bit d: entered in direction d at the least cost.
};

}  // namespace alate
