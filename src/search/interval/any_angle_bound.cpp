#include "search/interval/any_angle_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "search/grid/anya.hpp"
#include "space/bound/cell_plane.hpp"
#include "space/bound/passage.hpp"

namespace alate {

namespace {

/// Part of the bound within which its level is found.
constexpr double kNear = 1e-3;
/// Part of a length by which Anya's ties and rounding may have made it too long.
constexpr double kRounding = 1e-9;
constexpr int kPollEvery = 1024;

class AnyAngleBound {
 public:
  AnyAngleBound(const Problem& problem, const AnyAngleBoundOptions& options)
      : problem_(problem),
        air_(problem.world.site()),
        passage_(problem),
        plane_(problem.world.site(), air_.area(), options.most_cells),
        least_price_(plane_.size(), kUnseen) {}

  /// The least price of the sides of each cell; 0 where the flight may begin or end. False if stopped.
  bool price_cells(RunContext& run) {
    for (int cell = 0; cell < plane_.cells(); ++cell) {
      if (cell % kPollEvery == 0 && !run.keep_going()) return false;
      if (!air_.over(plane_.box(cell)).any()) least_price_[static_cast<std::size_t>(cell)] = kClosed;
    }
    for (int cell = 0; cell < plane_.cells(); ++cell) {
      if (cell % kPollEvery == 0 && !run.keep_going()) return false;
      if (price(cell) == kClosed) continue;
      plane_.for_sides_behind(cell, [&](const CellPlane::Side& side) { price_side(cell, side); });
    }
    for (int cell = 0; cell < plane_.cells(); ++cell)
      if (distance_to(plane_.box(cell), problem_.mission.goal.head<2>()) <= problem_.mission.tolerance_m)
        price(cell) = 0;
    price(plane_.cell_at(problem_.mission.start.head<2>())) = 0;
    return true;
  }

  /// What a route that costs less than `level` costs at the least; infinite if there is none, 0 if stopped.
  double least_below(double level, RunContext& run) const {
    HeightGrid grid{.columns = plane_.columns(), .rows = plane_.rows(), .cell_m = plane_.cell_m()};
    for (const double price : least_price_) grid.blocked.push_back(price < level ? 0 : 1);
    const BitGrid bits(grid);
    Anya anya(bits);
    const Vec2 start = problem_.mission.start.head<2>();
    const Vec2 goal = problem_.mission.goal.head<2>();
    const AnyAngleWay way = anya.find(place(start), place(goal), run);
    if (!way.finished) return 0;
    if (!way.found) return std::numeric_limits<double>::infinity();
    // Its ends are the middles of cells, and all cells of the goal's disc are free.
    const double spare = offset(start) + offset(goal) + problem_.mission.tolerance_m;
    return passage_.least(std::max(0.0, way.length * (1 - kRounding) * plane_.cell_m() - spare));
  }

 private:
  static constexpr double kUnseen = std::numeric_limits<double>::max();
  static constexpr double kClosed = std::numeric_limits<double>::infinity();

  void price_side(int cell, const CellPlane::Side& side) {
    if (price(side.other) == kClosed) return;
    const Altitudes open = air_.along(side.line.min, side.line.max);
    if (!open.any()) return;
    const double here = passage_.price(side.line, open);
    price(cell) = std::min(price(cell), here);
    price(side.other) = std::min(price(side.other), here);
  }
  double& price(int cell) { return least_price_[static_cast<std::size_t>(cell)]; }
  GridPlace place(const Vec2& at) const {
    const int cell = plane_.cell_at(at);
    return BitGrid::place(cell % plane_.columns(), cell / plane_.columns());
  }
  double offset(const Vec2& at) const {
    const Box2 box = plane_.box(plane_.cell_at(at));
    return (at - (box.min + box.max) / 2).norm();
  }

  const Problem& problem_;
  OpenAir air_;
  Passage passage_;
  CellPlane plane_;
  std::vector<double> least_price_;
};

}  // namespace

double any_angle_bound(const Problem& problem, const AnyAngleBoundOptions& options, RunContext& run) {
  AnyAngleBound bound(problem, options);
  double low = options.least;
  double high = options.most;
  if (!bound.price_cells(run)) return low;
  while (high - low > kNear * low && run.keep_going()) {
    const double level = (low + high) / 2;
    const double least = bound.least_below(level, run);
    low = std::max(low, std::min(least, level));
    if (least < level) high = level;
  }
  return low;
}

}  // namespace alate
