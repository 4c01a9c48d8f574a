// Planners that find the shortest way from cell to cell, and prove it.
#include "plan/grid/grid_exact.hpp"
#include "plan/grid/grid_planners.hpp"
#include "plan/terrain/terrain_planners.hpp"
#include "search/grid/astar.hpp"
#include "search/grid/jps.hpp"

namespace alate {

namespace {

/// From middle to middle, one place a corner.
struct CellToCell : GridLegs {
  static double least_length(const Problem& problem) { return alate::least_length(problem); }
  static std::vector<Vec3> places(const Problem& problem, const BitGrid& /*cells*/, const GridWay& way) {
    const HeightGrid& grid = *problem.world.site().grid;
    std::vector<Vec3> places;
    places.reserve(way.corners.size());
    for (const GridPlace corner : way.corners) places.push_back(grid.center(corner.column - 1, corner.row - 1));
    return places;
  }
  static double proven_cost(const Problem& /*problem*/, const GridWay& /*way*/, double cost) { return cost; }
};

template <class Search>
PlannerEntry exact_entry(std::string_view name, std::string_view help) {
  return grid_exact_entry<Search, CellToCell>(
      {.name = std::string(name),
       .help = std::string(help),
       .preset = {.name = "default", .help = "It has no parameters.", .values = {}},
       .fits = "on a grid where only length counts, exact search is quick and proves its route the shortest from cell "
               "to cell"});
}

}  // namespace

PlannerEntry jps_entry() {
  PlannerEntry entry = exact_entry<JumpPointSearch>(
      "jps",
      "Jump point search: the shortest way from cell to cell of a grid, proven, and the quickest to find it (Harabor "
      "and Grastien 2011, 2014).");
  entry.refuses = [](const Problem& problem) -> std::string {
    if (is_over_terrain(problem.world.site()))
      return "jumps over cells that all cost the same, and over terrain each leg has a cost of its own; take astar or "
             "theta-star";
    return grid_refusal(problem);
  };
  return entry;
}

PlannerEntry astar_entry() {
  return exact_entry<GridAStar>(
      "astar", "A*: the shortest way from cell to cell of a grid, proven (Hart, Nilsson and Raphael 1968).");
}

}  // namespace alate
