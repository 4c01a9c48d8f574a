#include "data/site_grid.hpp"

#include <fmt/core.h>

#include "data/grid_law.hpp"
#include "data/grid_map.hpp"

namespace alate {

std::optional<HeightGrid> read_grid(const Scenario& scenario, SiteFaults& faults) {
  const GridSpec& spec = *scenario.grid;
  std::optional<HeightGrid> grid;
  if (spec.random) {
    grid = draw_grid(*spec.random, scenario.start.place.cell, scenario.goal.place.cell);
  } else {
    std::vector<Fault> found;
    grid = read_grid_map(spec.map, found);
    for (Fault& fault : found) {
      if (fault.line > 0) {
        faults.add_found(std::move(fault));
      } else {
        fault.message = fmt::format("{}: {}", fault.file, fault.message);
        fault.field = "grid.map";
        faults.add(std::move(fault));
      }
    }
  }
  if (!grid) return std::nullopt;
  grid->cell_m = spec.cell_m;
  if (spec.heights == GridHeights::peaks) grid->height_m = peak_heights(grid->columns, grid->rows);
  return grid;
}

std::optional<Vec3> locate_cell(const HeightGrid& grid, const std::array<int, 2>& cell, const std::string& field,
                                SiteFaults& faults) {
  const auto& [column, row] = cell;
  const bool inside = grid.contains(column, row);
  if (inside && !grid.blocked_at(column, row)) return grid.center(column, row);
  faults.add({.field = field,
              .value = fmt::format("[{}, {}]", column, row),
              .limit = inside ? "" : fmt::format("[0, 0] to [{}, {}]", grid.columns - 1, grid.rows - 1),
              .message = inside ? "is a blocked cell" : "lies outside the grid"});
  return std::nullopt;
}

}  // namespace alate
