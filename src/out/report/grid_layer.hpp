// The cells of a grid on a map.
#pragma once

#include "alate/data/height_grid.hpp"
#include "out/report/hillshade.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/svg.hpp"

namespace alate {

/// Free cells tinted by height, blocked ones dark. One pixel a cell, or one for several of them on large grids, blocked
/// if any of these is. Bands are empty if the grid is flat.
Hillshade grid_picture(const HeightGrid& grid);

/// Lays the picture on the map, with the border of the grid and, where there is room, of its cells.
void draw_grid(Svg& svg, const MapFrame& map, const HeightGrid& grid, const Hillshade& picture);

}  // namespace alate
