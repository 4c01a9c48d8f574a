#include "search/grid/keep_clear.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

namespace {

/// A point of the way, and the direction in which free cells lie: 0, 1 or -1 on each axis.
struct Touch {
  GridPoint at;
  int right = 0;
  int down = 0;
};

int sign(int value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }

/// Away from the blocked cells at a corner; nowhere if there are none.
Touch touch_at(const BitGrid& grid, int x, int y) {
  Touch touch{{static_cast<double>(x), static_cast<double>(y)}};
  for (const int column : {-1, 0}) {
    for (const int row : {-1, 0}) {
      const GridPlace place{static_cast<std::uint16_t>(x + column), static_cast<std::uint16_t>(y + row)};
      if (grid.is_free(place)) continue;
      touch.right += column < 0 ? 1 : -1;
      touch.down += row < 0 ? 1 : -1;
    }
  }
  touch.right = sign(touch.right);
  touch.down = sign(touch.down);
  return touch;
}

bool is_corner(const GridPoint& point) { return point.x == std::floor(point.x) && point.y == std::floor(point.y); }

/// A leg by its longer axis.
class Leg {
 public:
  Leg(const GridPoint& from, const GridPoint& to)
      : from_(from), to_(to), steep_(std::abs(to.y - from.y) > std::abs(to.x - from.x)) {
    if (steep_) {
      std::swap(from_.x, from_.y);
      std::swap(to_.x, to_.y);
    }
  }

  /// Adds the corners between its ends that lie within `reach` of it, across the longer axis.
  void add_touches(const BitGrid& grid, double reach, std::vector<Touch>& touches) const {
    const int step = to_.x > from_.x ? 1 : -1;
    const double slope = (to_.y - from_.y) / (to_.x - from_.x);
    const double first = step > 0 ? std::floor(from_.x) + 1 : std::ceil(from_.x) - 1;
    for (auto x = static_cast<int>(first); step > 0 ? x < to_.x : x > to_.x; x += step) {
      const double y = from_.y + (x - from_.x) * slope;
      const auto corner = static_cast<int>(std::lround(y));
      if (std::abs(y - corner) > reach) continue;
      const Touch touch = steep_ ? touch_at(grid, corner, x) : touch_at(grid, x, corner);
      if (touch.right != 0 || touch.down != 0) touches.push_back(touch);
    }
  }
  /// Are two touches equally far off the leg?
  bool beside(const Touch& a, const Touch& b) const {
    if (from_.y == to_.y) return steep_ ? a.right == b.right : a.down == b.down;
    return a.right == b.right && a.down == b.down;
  }

 private:
  GridPoint from_, to_;  ///< Axes exchanged if it is steep.
  bool steep_;
};

/// All points of a leg but the first, without those between two others on one wall.
void add_leg(const BitGrid& grid, double reach, const GridPoint& to, std::vector<Touch>& way) {
  const Leg leg(way.back().at, to);
  std::vector<Touch> touches{way.back()};
  leg.add_touches(grid, reach, touches);
  touches.push_back(is_corner(to) ? touch_at(grid, static_cast<int>(to.x), static_cast<int>(to.y)) : Touch{to});
  for (std::size_t i = 1; i < touches.size(); ++i) {
    const bool between =
        i + 1 < touches.size() && leg.beside(touches[i - 1], touches[i]) && leg.beside(touches[i], touches[i + 1]);
    if (!between) way.push_back(touches[i]);
  }
}

}  // namespace

std::vector<GridPoint> kept_clear(const BitGrid& grid, const std::vector<GridPoint>& points, double hair) {
  constexpr double kReach = 4;  // hairs: what lies farther off stays clear of the moved legs by more than one
  std::vector<Touch> way{{points.front()}};
  for (std::size_t i = 1; i < points.size(); ++i) add_leg(grid, kReach * hair, points[i], way);
  std::vector<GridPoint> clear;
  clear.reserve(way.size());
  for (const Touch& touch : way) clear.push_back({touch.at.x + hair * touch.right, touch.at.y + hair * touch.down});
  return clear;
}

}  // namespace alate
