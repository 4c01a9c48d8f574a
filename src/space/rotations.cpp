#include "space/rotations.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alate {

RotationSet::RotationSet(const Vehicle& vehicle) {
  for (const double roll : vehicle.roll_rad)
    for (const double pitch : vehicle.pitch_rad)
      for (const double yaw : vehicle.yaw_rad) add({.roll_rad = roll, .pitch_rad = pitch, .yaw_rad = yaw});
}

void RotationSet::add(const AttitudeAction& action) {
  const Mat3 matrix = body_rotation(action);
  const Vec3 forward = matrix.col(0);
  actions_.push_back(action);
  matrices_.push_back(matrix);
  forward_x_.push_back(forward.x());
  forward_y_.push_back(forward.y());
  forward_z_.push_back(forward.z());
  largest_turn_ = std::max(largest_turn_, std::atan2(forward.tail<2>().norm(), forward.x()));
}

Mat3 body_rotation(const AttitudeAction& action) {
  using Eigen::AngleAxisd;
  return (AngleAxisd(action.roll_rad, Vec3::UnitX()) * AngleAxisd(-action.pitch_rad, Vec3::UnitY()) *
          AngleAxisd(-action.yaw_rad, Vec3::UnitZ()))
      .toRotationMatrix();
}

Mat3 level_attitude(double heading_rad) {
  const Vec3 forward = direction_of(heading_rad);
  Mat3 attitude;
  attitude << forward, Vec3(-forward.y(), forward.x(), 0), Vec3::UnitZ();
  return attitude;
}

}  // namespace alate
