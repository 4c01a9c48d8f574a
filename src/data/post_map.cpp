#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "alate/data/height_raster.hpp"

namespace alate {

namespace {

constexpr double kStraightness = 0.001;  ///< Posts.

/// Largest second difference of the knots: along either axis, plus the mixed one.
double bend_of(const std::vector<Vec2>& knots, int columns) {
  const auto rows = static_cast<int>(knots.size()) / columns;
  const auto knot = [&](int i, int j) { return knots[static_cast<std::size_t>(j * columns + i)]; };
  double along = 0;
  double mixed = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (i > 0 && i + 1 < columns) along = std::max(along, (knot(i - 1, j) - 2 * knot(i, j) + knot(i + 1, j)).norm());
      if (j > 0 && j + 1 < rows) along = std::max(along, (knot(i, j - 1) - 2 * knot(i, j) + knot(i, j + 1)).norm());
      if (i + 1 < columns && j + 1 < rows)
        mixed = std::max(mixed, (knot(i, j) - knot(i + 1, j) - knot(i, j + 1) + knot(i + 1, j + 1)).norm());
    }
  }
  return along + mixed;
}

/// Longest leg, in knot spacings, that departs less than kStraightness from straight. A curve of second
/// derivative `bend` departs by bend L^2 / 8; interpolating it between knots adds at most bend / 8, or what the
/// kinks at two crossed knot lines make of a short leg.
double straight_spacings(double bend) {
  const auto departure = [bend](double length) { return bend * (length * length / 8 + std::min(1.0 / 8, length / 2)); };
  double length = std::sqrt(8 * kStraightness / bend);
  while (departure(length) > kStraightness) length *= 0.95;
  return length;
}

}  // namespace

PostMap PostMap::affine(const std::array<double, 6>& coefficients) {
  PostMap map;
  map.affine_ = coefficients;
  map.straight_length_m_ = std::numeric_limits<double>::infinity();
  return map;
}

PostMap PostMap::lattice(const Box2& area, double spacing_m, int columns, std::vector<Vec2> knots) {
  assert(columns >= 2 && knots.size() >= 2 * static_cast<std::size_t>(columns));
  PostMap map;
  map.area_ = area;
  map.spacing_m_ = spacing_m;
  map.columns_ = columns;
  const double bend = bend_of(knots, columns);
  map.straight_length_m_ = bend > 0 ? spacing_m * straight_spacings(bend) : std::numeric_limits<double>::infinity();
  map.knots_ = std::move(knots);
  return map;
}

Vec2 PostMap::operator()(const Vec2& xy) const {
  if (knots_.empty())
    return {affine_[0] + affine_[1] * xy.x() + affine_[2] * xy.y(),
            affine_[3] + affine_[4] * xy.x() + affine_[5] * xy.y()};
  if (!area_.contains(xy)) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  const Vec2 at = (xy - area_.min) / spacing_m_;
  const int rows = static_cast<int>(knots_.size()) / columns_;
  const int i = std::min(static_cast<int>(at.x()), columns_ - 2);
  const int j = std::min(static_cast<int>(at.y()), rows - 2);
  const double u = at.x() - i;
  const double v = at.y() - j;
  const Vec2* low = knots_.data() + static_cast<std::ptrdiff_t>(j) * columns_ + i;
  const Vec2* high = low + columns_;
  return (1 - v) * ((1 - u) * low[0] + u * low[1]) + v * ((1 - u) * high[0] + u * high[1]);
}

}  // namespace alate
