#include "alate/data/peaks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alate {

double PeakGround::height(const Vec2& xy) const {
  double sum = 0;
  double highest = peaks.empty() ? 0 : -std::numeric_limits<double>::infinity();
  for (const Peak& peak : peaks) {
    const Vec2 from = (xy - peak.center).cwiseQuotient(peak.slope_m);
    const double height = peak.height_m * std::exp(-from.squaredNorm());
    sum += height;
    highest = std::max(highest, height);
  }
  return maximum ? highest : sum;
}

double PeakGround::steepness() const {
  // h exp(-r^2) is steepest at r = 1/sqrt(2), across the narrower side.
  static const double kSteepest = std::numbers::sqrt2 * std::exp(-0.5);
  double sum = 0;
  double steepest = 0;
  for (const Peak& peak : peaks) {
    const double slope = kSteepest * std::abs(peak.height_m) / peak.slope_m.cwiseAbs().minCoeff();
    sum += slope;
    steepest = std::max(steepest, slope);
  }
  return maximum ? steepest : sum;
}

}  // namespace alate
