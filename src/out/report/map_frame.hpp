// Which part of the frame a map shows, and where on the drawing it lies.
#pragma once

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Frame metres -> units of a drawing of the given width, north up.
struct MapFrame {
  Box2 area;
  double width = 0;

  double units_per_metre() const { return width / (area.max.x() - area.min.x()); }
  double height() const { return units_per_metre() * (area.max.y() - area.min.y()); }
  Vec2 operator()(const Vec2& xy) const {
    return {(xy.x() - area.min.x()) * units_per_metre(), (area.max.y() - xy.y()) * units_per_metre()};
  }
  Vec2 operator()(const Vec3& xyz) const { return (*this)(Vec2(xyz.head<2>())); }
};

/// Holds start, goal, route and the threats near them, with a margin; or the whole grid, or the voxels from above.
/// Neither a strip nor a tower.
MapFrame map_frame(const Site& site, const Route& route, double width);

}  // namespace alate
