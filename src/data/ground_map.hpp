// From frame metres to the posts of a raster in any CRS.
#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <optional>

#include "alate/data/height_raster.hpp"

namespace alate {

/// Where the posts of a raster lie, as GDAL tells it.
struct RasterGrid {
  int columns = 0;
  int rows = 0;
  std::array<double, 6> geotransform{};  ///< Of cell corners; posts are the cells' centres. Not singular.
  OGRSpatialReference crs;               ///< Horizontal part, longitude or easting first; empty if none.
};

struct GroundMap {
  PostMap map;
  Box2 area;          ///< Frame rectangle around all posts.
  double cell_m = 0;  ///< Mean distance between neighbouring posts.
};

/// Exact affine in a local frame, for a raster without CRS, and where both CRSs are the same; else a lattice of
/// projected knots, halved until interpolation between them is right to 0.0009 post at the middles of all lattice
/// squares and of their sides. Nothing if PROJ cannot follow the whole raster into the frame.
/// Cost: about 4 projections a knot; some hundred knots for 30 km of ground.
std::optional<GroundMap> map_ground(const RasterGrid& grid, const Frame& frame);

}  // namespace alate
