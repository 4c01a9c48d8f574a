// Heights as a raster file.
#pragma once

#include <string>

#include "data/terrain_law.hpp"

namespace alate {

/// A GeoTIFF of whole metres, deflated, with no place on Earth. Throws std::runtime_error if memory fails.
std::string geotiff(const DrawnTerrain& terrain);

}  // namespace alate
