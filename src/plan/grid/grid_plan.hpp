// What all planners on height grids share: when they refuse, the proof that there is no way, and the way from a string
// of moves to a Plan.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "alate/plan/planner.hpp"
#include "space/height_grid.hpp"

namespace alate {

/// Why shortest routes from cell to cell are not what the problem asks for; empty if they are.
std::string grid_refusal(const Problem& problem);

/// The part of a refusal that maps of any kind share: what steps from cell to cell do not know of.
std::string step_refusal(const Problem& problem);

/// Column and row of a cell, (0, 0) in the upper left.
struct GridCellPlace {
  int column = 0;
  int row = 0;
};

struct GridEnds {
  GridCellPlace start;
  GridCellPlace goal;
};

/// Of a problem that is not refused.
GridEnds grid_ends(const Problem& problem);

/// No string of moves is shorter, metres: the shortest way were all cells free.
double least_length(const Problem& problem);

/// Where moves from the start end, in words, for a goal that they do not reach.
std::string no_way(const Problem& problem);

/// Cost of a diagonal step where a straight one costs 1, and how routes are judged.
struct GridOptions {
  double diagonal = 0;
  GridScore score;
};

/// What a search on a grid found.
struct GridFound {
  bool found = false;
  std::vector<std::uint32_t> directions;
  std::uint64_t moves = 0;  ///< That were tried.
  std::vector<IterationStats> history;
};

using GridSearch = std::function<GridFound(const GridSpace&)>;

/// Builds the space, runs `search` and wraps up. Where no string of moves leads to the goal, that is proven by flooding
/// the cells from the start, and `search` is not asked. The counter `last_change` is the last iteration that changed
/// the best length. The lower bound is the shortest way were all cells free.
Plan plan_on_grid(const Problem& problem, RunContext& run, const GridOptions& options, const GridSearch& search);

}  // namespace alate
