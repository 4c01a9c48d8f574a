// Shortcuts by sight: a stretch of a route on a grid is replaced by one that is as short as if all cells were free.
//
// Two cells see each other if one of two connections is free: all diagonal steps and then the straight ones, or the
// other way round. That is looked at and no more: nothing is searched, and no way leads round a blocked cell. All
// stretches of up to `reach` moves are tried, the longest first, until none gets shorter.
//
// Source: alate; string pulling as in any-angle planning (Daniel et al. 2010, post-smoothed A*), with moves of the grid
// for lines. Cost: moves x reach x 2 reach at worst; most stretches are found to be shortest at a glance.
#pragma once

#include <span>
#include <vector>

#include "aco/ant.hpp"
#include "alate/core/run_context.hpp"
#include "space/height_grid.hpp"

namespace alate {

class Sight {
 public:
  explicit Sight(std::size_t reach) : reach_(reach) {}

  /// Improves actions, sum and cost of an ant that arrived; was its route changed? Only where length alone counts.
  bool operator()(const GridSpace& space, Ant& ant, double best, RunContext& run);

 private:
  using Cell = GridSpace::Cell;

  bool shorten(const GridSpace& space);
  bool shorten_from(const GridSpace& space, std::size_t first);
  bool connect(const GridSpace& space, Cell from, Cell to);
  bool is_free(const GridSpace& space, Cell cell) const;
  void splice(const GridSpace& space, std::size_t first, std::size_t last);

  std::size_t reach_;
  std::vector<std::uint32_t> moves_;   ///< Directions of the route.
  std::vector<Cell> cells_;            ///< One more.
  std::vector<double> until_;          ///< Length until each cell.
  std::vector<std::uint32_t> bridge_;  ///< Directions of the connection found last.
};

}  // namespace alate
