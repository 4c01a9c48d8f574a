#include "study/page/camera.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace alate {

Camera::Camera(double azimuth_rad, double elevation_rad)
    : towards_(direction_of(azimuth_rad) * std::cos(elevation_rad) + Vec3::UnitZ() * std::sin(elevation_rad)) {
  const Vec3 away = -direction_of(azimuth_rad);
  right_ = away.cross(Vec3::UnitZ());
  up_ = towards_.cross(right_);
}

}  // namespace alate
