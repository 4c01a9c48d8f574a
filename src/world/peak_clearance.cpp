#include "world/peak_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance_m = 0.05;
constexpr int kDeepest = 48;

/// Part of a leg with the height above the ground at both ends.
struct Part {
  double from = 0;
  double to = 1;
  double above_from = 0;
  double above_to = 0;
  int depth = 0;
};

/// How far hills may rise above (`up`) or sink below (`down`) the chord over a part of the leg.
struct Bulge {
  double up = 0;
  double down = 0;
};

class PeakLeg {
 public:
  PeakLeg(const PeakGround& ground, const Segment& leg) : ground_(ground), leg_(leg) {}

  Part whole() const { return {.from = 0, .to = 1, .above_from = above(0), .above_to = above(1)}; }

  /// Lower of `best` and the bound of `part`; gives up below `stop`. `bound` holds for what encloses the part.
  double lowest(const Part& part, double bound, double best, double stop) const {
    const double rise = bulge(part).up;
    bound = std::max(bound, std::min(part.above_from, part.above_to) - rise);
    if (bound >= best) return best;
    if (!(rise > kTolerance_m) || part.depth == kDeepest) return bound;
    const double middle = 0.5 * (part.from + part.to);
    const double above_middle = above(middle);
    best = lowest({part.from, middle, part.above_from, above_middle, part.depth + 1}, bound, best, stop);
    if (best < stop) return best;
    return lowest({middle, part.to, above_middle, part.above_to, part.depth + 1}, bound, best, stop);
  }

  /// Is the part everywhere at most `roof` above the ground?
  bool below(const Part& part, double roof) const {
    const double highest_end = std::max(part.above_from, part.above_to);
    if (highest_end > roof) return false;
    const double bound = highest_bound(part);
    if (bound <= roof) return true;
    const double middle = 0.5 * (part.from + part.to);
    const double above_middle = above(middle);
    if (!(bound - std::max(highest_end, above_middle) > kTolerance_m) || part.depth == kDeepest) return false;
    return below({part.from, middle, part.above_from, above_middle, part.depth + 1}, roof) &&
           below({middle, part.to, above_middle, part.above_to, part.depth + 1}, roof);
  }

 private:
  Vec2 position(double t) const { return leg_.at(t).head<2>(); }
  double above(double t) const { return leg_.at(t).z() - ground_.height(position(t)); }

  /// Bulge of one hill h exp(-r^2): its second derivative along w lies between -2 h w^2 exp(-r^2) and
  /// h w^2 (4 r^2 - 2) exp(-r^2), which is largest at r^2 = 3/2.
  Bulge bulge_of(const Peak& peak, const Part& part) const {
    const Vec2 from = (position(part.from) - peak.center).cwiseQuotient(peak.slope_m);
    const Vec2 along = (position(part.to) - position(part.from)).cwiseQuotient(peak.slope_m);
    const double w2 = along.squaredNorm();
    const double t = w2 > 0 ? std::clamp(-from.dot(along) / w2, 0.0, 1.0) : 0;
    const double r2 = (from + t * along).squaredNorm();
    const double size = std::abs(peak.height_m) * w2 / 8;
    const double concave = size * 2 * std::exp(-r2);
    const double steepest = std::max(r2, 1.5);
    const double convex = size * (4 * steepest - 2) * std::exp(-steepest);
    return peak.height_m >= 0 ? Bulge{concave, convex} : Bulge{convex, concave};
  }

  Bulge bulge(const Part& part) const {
    Bulge sum;
    Bulge largest;
    for (const Peak& peak : ground_.peaks) {
      const Bulge one = bulge_of(peak, part);
      sum = {sum.up + one.up, sum.down + one.down};
      largest = {std::max(largest.up, one.up), std::max(largest.down, one.down)};
    }
    return ground_.maximum ? largest : sum;
  }

  /// No point of the part is higher above the ground. The maximum of hills has valleys that no curvature
  /// bounds, but it is nowhere lower than the hill that is highest in the middle.
  double highest_bound(const Part& part) const {
    if (!ground_.maximum || ground_.peaks.empty()) return std::max(part.above_from, part.above_to) + bulge(part).down;
    const Vec2 middle = position(0.5 * (part.from + part.to));
    const auto height_at = [](const Peak& peak, const Vec2& xy) {
      return peak.height_m * std::exp(-(xy - peak.center).cwiseQuotient(peak.slope_m).squaredNorm());
    };
    const Peak& peak =
        *std::ranges::max_element(ground_.peaks, {}, [&](const Peak& p) { return height_at(p, middle); });
    const double from = leg_.at(part.from).z() - height_at(peak, position(part.from));
    const double to = leg_.at(part.to).z() - height_at(peak, position(part.to));
    return std::max(from, to) + bulge_of(peak, part).down;
  }

  const PeakGround& ground_;
  const Segment& leg_;
};

bool inside(const PeakGround& ground, const Segment& leg) {
  return ground.area.contains(leg.a.head<2>()) && ground.area.contains(leg.b.head<2>());
}

}  // namespace

double clearance(const PeakGround& ground, const Segment& leg) {
  if (!inside(ground, leg)) return -kInfinity;
  const PeakLeg along(ground, leg);
  return along.lowest(along.whole(), -kInfinity, kInfinity, -kInfinity);
}

bool within(const PeakGround& ground, const Segment& leg, double floor, double roof) {
  if (!inside(ground, leg)) return false;
  const PeakLeg along(ground, leg);
  const Part whole = along.whole();
  if (along.lowest(whole, -kInfinity, floor, floor) < floor) return false;
  return roof == kInfinity || along.below(whole, roof);
}

}  // namespace alate
