#include "alate/data/height_raster.hpp"

#include <algorithm>

namespace alate {

std::optional<double> HeightRaster::height(const Vec2& xy) const {
  const Vec2 at = map(xy);
  if (!covers(at)) return std::nullopt;
  const int column = std::min(static_cast<int>(at.x()), columns - 2);
  const int row = std::min(static_cast<int>(at.y()), rows - 2);
  const double u = at.x() - column;
  const double v = at.y() - row;
  const double upper = (1 - u) * double{post(column, row)} + u * double{post(column + 1, row)};
  const double lower = (1 - u) * double{post(column, row + 1)} + u * double{post(column + 1, row + 1)};
  return (1 - v) * upper + v * lower;
}

}  // namespace alate
