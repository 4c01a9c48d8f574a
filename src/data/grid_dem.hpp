// A grid cut from a raster of ground heights, for flight at one level.
#pragma once

#include <optional>

#include "alate/core/scenario.hpp"
#include "alate/data/height_grid.hpp"
#include "alate/data/height_raster.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// All whole cells of `spec.cell_m` within the raster, their sides at whole multiples of it in the frame. A cell is as
/// high as the highest post of the raster's own cells that it touches: never lower than its ground, and higher by at
/// most what the ground rises within one post spacing. It is blocked where this height plus `spec.clearance_m` reaches
/// `spec.level_amsl_m`, and where any of these posts is void or missing. Nothing, and a fault at `grid.cell_m`, where
/// not one cell fits in or there are more than a grid may have. Cost: some 100 ns a cell, and a look at every post.
std::optional<HeightGrid> cut_grid(const HeightRaster& raster, const GridSpec& spec, SiteFaults& faults);

}  // namespace alate
