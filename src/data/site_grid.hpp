// The grid of a scenario, and places on it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "alate/data/site.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// Reads or draws `scenario.grid`, which is not cut from a raster; nothing, and faults, where the map cannot be read.
std::optional<HeightGrid> read_grid(const Scenario& scenario, SiteFaults& faults);

/// Reads the voxel map of `scenario.grid`; as above.
std::optional<VoxelGrid> read_voxels(const Scenario& scenario, SiteFaults& faults);

/// Centre of the cell of the site's grid or voxels that `place` names; nothing, and a fault at `field`, where it is
/// blocked or outside, or has not as many numbers as the map has axes.
std::optional<Vec3> locate_cell(const Site& site, const PlaceSpec& place, const std::string& field, SiteFaults& faults);

/// Centre of `cell` of the site's grid; nothing, and a fault at `field`, where it is blocked or outside.
std::optional<Vec3> locate_cell(const Site& site, const std::array<int, 2>& cell, const std::string& field,
                                SiteFaults& faults);

}  // namespace alate
