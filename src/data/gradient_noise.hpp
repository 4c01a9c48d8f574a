// Smooth noise over the plane, the same on every machine.
#pragma once

#include <vector>

#include "alate/core/geometry.hpp"
#include "alate/core/stream.hpp"

namespace alate {

/// Noise of one wavelength over [0, width]^2, 0 on average and within 0.71 either side: every point of a lattice has a
/// ramp of its own, and between four of them these are faded into each other (Perlin 1985, with the fade of 2002).
/// Sums and products only.
class GradientNoise {
 public:
  GradientNoise(double wavelength_m, double width_m, Stream random);

  double operator()(const Vec2& place) const;

 private:
  double per_wavelength_;
  std::size_t columns_;
  std::vector<Vec2> gradients_;  ///< Row-major; unit vectors.
};

}  // namespace alate
