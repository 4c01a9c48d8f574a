#include "data/site_grid.hpp"

#include <fmt/core.h>

#include <cmath>

#include "data/grid_law.hpp"
#include "data/grid_map.hpp"
#include "data/voxel_map.hpp"

namespace alate {

namespace {

/// Why the cell is blocked, as far as the site knows.
std::string blocked_because(const Site& site, double height_m) {
  if (!site.has_ground()) return "is a blocked cell";
  if (std::isnan(height_m)) return "is a blocked cell: its ground is unknown (voids, or the edge of the raster)";
  return fmt::format("is a blocked cell: its ground and clearance_m reach {:.1f} m, the flight level is {:.1f} m",
                     height_m + site.band.clearance_m, site.grid->level_m);
}

/// Faults inside a map name their line; those of the map as a whole stand at the scenario's field.
void add_map_faults(std::vector<Fault> found, SiteFaults& faults) {
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

std::optional<Vec3> locate_voxel(const VoxelGrid& voxels, const VoxelCell& cell, const std::string& field,
                                 SiteFaults& faults) {
  if (voxels.is_free(cell)) return voxels.center(cell);
  const bool inside = voxels.contains(cell);
  const auto& [x, y, z] = voxels.size();
  faults.add({.field = field,
              .value = fmt::format("[{}, {}, {}]", cell[0], cell[1], cell[2]),
              .limit = inside ? "" : fmt::format("[0, 0, 0] to [{}, {}, {}]", x - 1, y - 1, z - 1),
              .message = inside ? "is a blocked cell" : "lies outside the map"});
  return std::nullopt;
}

}  // namespace

std::optional<HeightGrid> read_grid(const Scenario& scenario, SiteFaults& faults) {
  const GridSpec& spec = *scenario.grid;
  std::optional<HeightGrid> grid;
  if (spec.random) {
    grid = draw_grid(*spec.random, scenario.start.place.cell, scenario.goal.place.cell);
  } else {
    std::vector<Fault> found;
    grid = read_grid_map(spec.map, found);
    add_map_faults(std::move(found), faults);
  }
  if (!grid) return std::nullopt;
  grid->cell_m = spec.cell_m;
  if (spec.heights == GridHeights::peaks) grid->height_m = peak_heights(grid->columns, grid->rows);
  return grid;
}

std::optional<VoxelGrid> read_voxels(const Scenario& scenario, SiteFaults& faults) {
  const GridSpec& spec = *scenario.grid;
  if (spec.heights != GridHeights::flat) faults.add({.field = "grid.heights", .message = "voxels have no heights"});
  std::vector<Fault> found;
  auto voxels = read_voxel_map(spec.map, found);
  add_map_faults(std::move(found), faults);
  if (voxels) voxels->cell_m = spec.cell_m;
  return voxels;
}

std::optional<Vec3> locate_cell(const Site& site, const PlaceSpec& place, const std::string& field,
                                SiteFaults& faults) {
  const auto& [x, y] = *place.cell;
  if (site.voxels && place.layer) return locate_voxel(*site.voxels, {x, y, *place.layer}, field, faults);
  if (site.grid && !place.layer) return locate_cell(site, *place.cell, field, faults);
  faults.add(
      {.field = field,
       .value = place.layer ? fmt::format("[{}, {}, {}]", x, y, *place.layer) : fmt::format("[{}, {}]", x, y),
       .limit = site.voxels ? "[x, y, z]" : "[column, row]",
       .message = site.voxels ? "a cell of a voxel map has three numbers" : "a cell of this grid has two numbers"});
  return std::nullopt;
}

std::optional<Vec3> locate_cell(const Site& site, const std::array<int, 2>& cell, const std::string& field,
                                SiteFaults& faults) {
  const HeightGrid& grid = *site.grid;
  const auto& [column, row] = cell;
  const bool inside = grid.contains(column, row);
  if (inside && !grid.blocked_at(column, row)) return grid.center(column, row);
  faults.add({.field = field,
              .value = fmt::format("[{}, {}]", column, row),
              .limit = inside ? "" : fmt::format("[0, 0] to [{}, {}]", grid.columns - 1, grid.rows - 1),
              .message = inside ? blocked_because(site, grid.height_at(column, row)) : "lies outside the grid"});
  return std::nullopt;
}

}  // namespace alate
