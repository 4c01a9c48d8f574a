// Dubins lengths of many pairs of poses at once; bit for bit those of `dubins_length`.
#pragma once

#include "space/dubins/planar_pose.hpp"
#include "space/simd.hpp"

namespace alate {

/// Poses as columns of one length.
struct PoseColumns {
  AlignedDoubles x, y, heading, cos, sin;

  std::size_t size() const { return x.size(); }
  void reserve(std::size_t count);
  void clear();
  void push_back(const PlanarPose& pose);
};

/// Fills `lengths_m` with the length from every pose to one.
void dubins_lengths(const PoseColumns& from, const PlanarPose& to, double radius_m, AlignedDoubles& lengths_m);

/// From one pose to each of many.
void dubins_lengths(const PlanarPose& from, const PoseColumns& to, double radius_m, AlignedDoubles& lengths_m);

/// From each pose to the one at the same place of `to`, which is as long.
void dubins_lengths(const PoseColumns& from, const PoseColumns& to, double radius_m, AlignedDoubles& lengths_m);

}  // namespace alate
