// Axonometric view: space seen from far away, so that spheres are drawn as circles.
#pragma once

#include "alate/core/geometry.hpp"

namespace alate {

/// Orthographic projection. Depth grows towards the viewer.
class Camera {
 public:
  /// The viewer stands in direction `azimuth_rad` (clockwise from +y) and looks down by `elevation_rad`.
  Camera(double azimuth_rad, double elevation_rad);

  /// Right and up on the picture.
  Vec2 project(const Vec3& point) const { return {right_.dot(point), up_.dot(point)}; }
  double depth(const Vec3& point) const { return towards_.dot(point); }
  /// Unit vector from the scene to the viewer.
  const Vec3& towards() const { return towards_; }

 private:
  Vec3 right_;
  Vec3 up_;
  Vec3 towards_;
};

}  // namespace alate
