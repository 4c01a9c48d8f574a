// Analytic ground of Gaussian hills.
#pragma once

#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

struct Peak {
  Vec2 center;
  double height_m = 0;
  Vec2 slope_m;
};

/// Height(x, y) = sum or maximum of h exp(-((x-cx)/sx)^2 - ((y-cy)/sy)^2) (Mai et al. 2023, eq. 1) on [0,w] x [0,h].
struct PeakGround {
  std::vector<Peak> peaks;
  bool maximum = false;
  Box2 area;

  double height(const Vec2& xy) const;
  /// No two points at distance d differ by more than d times this.
  double steepness() const;
};

}  // namespace alate
