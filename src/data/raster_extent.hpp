// Where on Earth a raster lies, in words a user can compare with his own coordinates.
#pragma once

#include <optional>
#include <string>

#include "alate/core/frame.hpp"

namespace alate {

/// Latitudes and longitudes around a raster's posts.
struct GeoBox {
  GeoPoint min;
  GeoPoint max;
  GeoPoint middle;  ///< Of the raster itself, also where the date line runs through it.

  bool contains(const GeoPoint& point) const;
  /// "lat 36.16000 to 36.44583, lon -84.41333 to -84.07833".
  std::string text() const;
};

/// Nothing where the file cannot be opened or has no place on Earth.
std::optional<GeoBox> raster_extent(const std::string& file);

}  // namespace alate
