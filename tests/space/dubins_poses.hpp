// Poses for tests of Dubins paths, and what rounding may do to them.
#pragma once

#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "space/dubins/planar_pose.hpp"

namespace alate::dubins_test {

inline constexpr double kRadius = 66.67;

inline double gap(const PlanarPose& a, const PlanarPose& b) {
  return std::hypot(a.x - b.x, a.y - b.y) + kRadius * std::abs(wrapped(a.heading - b.heading));
}

/// What ends of paths and lengths may be off.
inline double tolerance(const PlanarPose& a, const PlanarPose& b) {
  return 1e-9 * (kRadius + std::hypot(a.x - b.x, a.y - b.y)) +
         1e-14 * (std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y));
}

inline std::string text(const PlanarPose& pose) {
  std::ostringstream out;
  out.precision(17);
  out << "(" << pose.x << ", " << pose.y << ", " << pose.heading << ")";
  return out.str();
}

class Random {
 public:
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(engine_); }
  PlanarPose pose(double size) {
    return planar_pose(between(-size, size) * kRadius, between(-size, size) * kRadius, between(-kPi, kPi));
  }

 private:
  std::mt19937_64 engine_{1};
};

}  // namespace alate::dubins_test
