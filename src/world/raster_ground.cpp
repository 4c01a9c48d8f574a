#include "world/raster_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/cell_walk.hpp"

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Bounds and closed forms round differently; only what differs by more may be decided by a bound.
constexpr double kRounding_m = 1e-6;

/// Height above the ground inside one cell: c0 + c1 s + c2 s^2 for s in [0, end].
struct Quadratic {
  double c0 = 0;
  double c1 = 0;
  double c2 = 0;
  double end = 0;

  double at(double s) const { return c0 + s * (c1 + s * c2); }
  double last() const { return at(end); }
  /// A vertex within the cell lies at most this far beyond the nearer end.
  double bulge() const { return 0.25 * std::abs(c2) * end * end; }
  /// Is there a lowest point between the ends? Its height is that of the vertex.
  bool dips() const { return c2 > 0 && c1 < 0 && c1 + 2 * c2 * end > 0; }
  bool arches() const { return c2 < 0 && c1 > 0 && c1 + 2 * c2 * end < 0; }
  double vertex() const { return at(-c1 / (2 * c2)); }
  double lowest() const { return dips() ? std::min({c0, last(), vertex()}) : std::min(c0, last()); }
  double highest() const { return arches() ? std::max({c0, last(), vertex()}) : std::max(c0, last()); }
  bool unknown() const { return std::isnan(c2); }
};

/// Searches the lowest clearance.
struct Lowest {
  double best = kInfinity;

  bool may_skip(double low, double /*high*/) const { return low > best + kRounding_m; }
  bool accept(const Quadratic& above) {
    best = std::min({best, above.c0, above.last()});
    if (above.dips()) best = std::min(best, above.vertex());
    if (above.unknown()) best = -kInfinity;
    return best > -kInfinity;
  }
};

/// Stops at the first cell below `floor` or above `roof`.
struct Within {
  double floor = 0;
  double roof = kInfinity;

  bool may_skip(double low, double high) const { return low > floor + kRounding_m && high < roof - kRounding_m; }
  bool accept(const Quadratic& above) const {
    const double first = above.c0;
    const double last = above.last();
    const double bulge = above.bulge();
    if (std::min(first, last) - bulge > floor && std::max(first, last) + bulge < roof) return true;
    return !above.unknown() && above.lowest() >= floor && (roof == kInfinity || above.highest() <= roof);
  }
};

/// Height above the ground over the part [t, t_out] of the walk that lies in its cell.
Quadratic above_cell(const HeightRaster& raster, const CellWalk& walk, double t_out) {
  const float* upper = raster.posts.data() + static_cast<std::ptrdiff_t>(walk.row) * raster.columns + walk.column;
  const float* lower = upper + raster.columns;
  const auto h = double{upper[0]};
  const double b = double{upper[1]} - h;
  const double c = double{lower[0]} - h;
  const double d = double{lower[1]} - double{lower[0]} - b;
  const double u = walk.x + walk.dx * walk.t - walk.column;
  const double v = walk.y + walk.dy * walk.t - walk.row;
  const double ground = h + u * b + v * (c + u * d);
  const double slope = walk.dx * (b + v * d) + walk.dy * (c + u * d);
  return {
      .c0 = walk.height(walk.t) - ground, .c1 = walk.dz - slope, .c2 = -walk.dx * walk.dy * d, .end = t_out - walk.t};
}

/// Walks the leg until its end (true) or until `goal` has seen enough (false).
template <class Goal>
bool run(const HeightRaster& raster, const HeightPyramid& pyramid, CellWalk walk, Goal& goal) {
  constexpr int kShift = HeightPyramid::kShift;
  // A bound costs as much as a cell and often decides nothing near the ground: over a few cells it is not worth it.
  constexpr double kManyCells = 16;
  const int top = std::abs(walk.dx) + std::abs(walk.dy) > kManyCells ? pyramid.top() : 0;
  int level = std::min(1, top);
  for (;;) {
    const int column = walk.column;
    const int row = walk.row;
    const auto exit = walk.exit(kShift * level);
    if (level == 0) {
      if (!goal.accept(above_cell(raster, walk, exit.t))) return false;
      if (!walk.step(exit)) return true;
    } else {
      const auto& range = pyramid.block(level, column, row);
      const double z_in = walk.height(walk.t);
      const double z_out = walk.height(exit.t);
      if (!goal.may_skip(std::min(z_in, z_out) - double{range.high}, std::max(z_in, z_out) - double{range.low})) {
        --level;
        continue;
      }
      if (!walk.leave(exit, kShift * level)) return true;
    }
    // Try the next coarser block only where the walk has just entered one.
    const bool entered = (((column ^ walk.column) | (row ^ walk.row)) >> (kShift * (level + 1))) != 0;
    if (entered && level < top) ++level;
  }
}

}  // namespace

template <class Goal>
bool RasterGround::follow(const Segment& leg, Goal& goal) const {
  Vec2 from = raster_.map(leg.a.head<2>());
  const Vec2 end = raster_.map(leg.b.head<2>());
  if (!raster_.covers(from) || !raster_.covers(end)) return false;
  const double climb = leg.b.z() - leg.a.z();
  for (double t = 0; t < 1;) {
    const double t_to = raster_.map.straight_until(leg.a.head<2>(), leg.b.head<2>(), t);
    const Vec2 to = t_to < 1 ? raster_.map(leg.at(t_to).head<2>()) : end;
    if (!raster_.covers(to)) return false;
    const CellWalk walk({.from = from, .to = to, .z = leg.a.z() + t * climb, .dz = (t_to - t) * climb},
                        raster_.columns - 1, raster_.rows - 1);
    if (!run(raster_, pyramid_, walk, goal)) return false;
    from = to;
    t = t_to;
  }
  return true;
}

double RasterGround::clearance(const Segment& leg) const {
  Lowest goal;
  return follow(leg, goal) ? goal.best : -kInfinity;
}

bool RasterGround::within(const Segment& leg, double floor, double roof) const {
  Within goal{.floor = floor, .roof = roof};
  return follow(leg, goal);
}

}  // namespace alate
