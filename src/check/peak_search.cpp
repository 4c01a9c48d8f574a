#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "check/height_range.hpp"

namespace alate {

namespace {

constexpr double kEnough = 0.05;
constexpr int kMostBisections = 200'000;

struct Interval {
  double t0, t1;
  double f0, f1;
  double bound;  ///< Nothing in the interval lies below.

  bool operator>(const Interval& other) const { return bound > other.bound; }
};

struct Minimum {
  double bound;  ///< At most the truth.
  double at;
};

/// Smallest value over [0, 1] of a function that changes by at most `slope` * |dt|.
Minimum minimize(const std::function<double(double)>& f, double slope) {
  const auto interval = [&](double t0, double t1, double f0, double f1) {
    return Interval{t0, t1, f0, f1, std::min({f0, f1, (f0 + f1 - slope * (t1 - t0)) / 2})};
  };
  std::priority_queue<Interval, std::vector<Interval>, std::greater<>> open;
  open.push(interval(0, 1, f(0), f(1)));
  double best = std::min(open.top().f0, open.top().f1);
  double at = open.top().f0 <= open.top().f1 ? 0 : 1;
  for (int i = 0; i < kMostBisections && open.top().bound < best - kEnough; ++i) {
    const Interval top = open.top();
    open.pop();
    const double middle = (top.t0 + top.t1) / 2;
    const double value = f(middle);
    if (value < best) {
      best = value;
      at = middle;
    }
    open.push(interval(top.t0, middle, top.f0, value));
    open.push(interval(middle, top.t1, value, top.f1));
  }
  return {std::min(best, open.top().bound), at};
}

}  // namespace

HeightRange height_range(const PeakGround& peaks, const Segment& piece) {
  HeightRange range;
  const auto inside = clipped(piece, peaks.area);
  if (!inside) return range;
  const auto above = [&](double t) {
    const Vec3 at = inside->at(t);
    return at.z() - peaks.height(at.head<2>());
  };
  const double slope = std::abs(inside->b.z() - inside->a.z()) + peaks.steepness() * inside->planar_length();
  const Minimum low = minimize(above, slope);
  const Minimum high = minimize([&](double t) { return -above(t); }, slope);
  range.lowest = HeightAt{low.bound, inside->at(low.at)};
  range.highest = HeightAt{-high.bound, inside->at(high.at)};
  return range;
}

}  // namespace alate
