// The cells of a grid, or voxels from above, on a map.
#pragma once

#include "alate/data/height_grid.hpp"
#include "alate/data/voxel_grid.hpp"
#include "out/report/hillshade.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/svg.hpp"

namespace alate {

/// Free cells tinted by height, blocked ones dark. One pixel a cell, or one for several of them on large grids, blocked
/// if any of these is. Bands are empty if the grid is flat.
Hillshade grid_picture(const HeightGrid& grid);

/// Voxels from above: as high as the top of the highest blocked cell of each column, NaN where none is blocked.
HeightGrid seen_from_above(const VoxelGrid& voxels);

/// Columns of voxels seen from above tinted by height, pale where none is blocked. As many pixels as above, as high as
/// the highest of their columns.
Hillshade voxel_picture(const HeightGrid& tops);

/// Lays the picture on the map, with the border of the grid and, where there is room, of its cells.
void draw_grid(Svg& svg, const MapFrame& map, const HeightGrid& grid, const Hillshade& picture);

}  // namespace alate
