// Sites on drawn height grids, and their shortest ways.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "alate/data/site.hpp"
#include "data/grid_law.hpp"
#include "space/height_grid.hpp"

namespace alate::test {

/// From the lower left corner to the upper right one.
inline Site grid_site(HeightGrid grid) {
  Site site;
  site.scenario.objective.climb = 0;
  site.mission.start = grid.center(0, grid.rows - 1);
  site.mission.goal = grid.center(grid.columns - 1, 0);
  site.grid = std::move(grid);
  return site;
}

/// The law of the maps behind Yin et al. 2021: cells blocked at random, corners free, heights |peaks|.
inline HeightGrid drawn_grid(int side, std::uint64_t seed, double obstacles = 0.2) {
  const RandomGridSpec spec{.size = {side, side}, .obstacles = obstacles, .seed = static_cast<int>(seed)};
  HeightGrid grid = draw_grid(spec, std::array{0, side - 1}, std::array{side - 1, 0});
  grid.height_m = peak_heights(side, side);
  return grid;
}

/// `#` is blocked; the first line is the upper row.
inline HeightGrid grid_of(const std::vector<std::string>& lines) {
  HeightGrid grid{.columns = static_cast<int>(lines.front().size()),
                  .rows = static_cast<int>(lines.size()),
                  .blocked = {},
                  .height_m = {}};
  for (const std::string& line : lines)
    for (const char c : line) grid.blocked.push_back(c == '#' ? 1 : 0);
  return grid;
}

/// The space from the lower left corner to the upper right one. `grid` must outlive it.
inline GridSpace corner_space(const HeightGrid& grid, double diagonal, const GridScore& score = {}) {
  return {grid, {0, grid.rows - 1, grid.columns - 1, 0}, diagonal, score};
}

/// By sweeps over all moves until nothing changes; infinite where there is no way.
inline double shortest_length(const GridSpace& space) {
  std::vector<double> length(space.cells(), std::numeric_limits<double>::infinity());
  length[space.start()] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (GridSpace::Cell cell = 0; cell < space.cells(); ++cell) {
      for (unsigned d = 0; d < GridSpace::kDirections; ++d) {
        if (((space.open(cell) >> d) & 1U) == 0) continue;
        double& next = length[space.neighbour(cell, d)];
        if (!(length[cell] + space.step(d) < next)) continue;
        next = length[cell] + space.step(d);
        changed = true;
      }
    }
  }
  return length[space.goal()];
}

}  // namespace alate::test
