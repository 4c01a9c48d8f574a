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
/// derivative `bend` departs by bend L^2 / 8; interpolating it between knots adds at most bend / 4, or what the
/// kinks at the crossed lines make of a short leg.
double straight_spacings(double bend) {
  const auto departure = [bend](double length) { return bend * (length * length / 8 + std::min(1.0 / 4, length / 2)); };
  double length = std::sqrt(8 * kStraightness / bend);
  while (departure(length) > kStraightness) length *= 0.95;
  return length;
}

/// First parameter after `t` at which from + t along, not negative, is a whole number. A line less than 1e-9 of
/// the leg ahead is taken as passed: rounding puts the line just crossed there.
double next_line(double from, double along, double t) {
  constexpr double kPassed = 1e-9;
  if (along == 0) return std::numeric_limits<double>::infinity();
  const double line = static_cast<int>(from + t * along) + (along > 0 ? 1 : 0);
  const double crossing = (line - from) / along;
  return crossing > t + kPassed ? crossing : crossing + 1 / std::abs(along);
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
  map.per_spacing_ = 1 / spacing_m;
  map.columns_ = columns;
  map.rows_ = static_cast<int>(knots.size()) / columns;
  const double bend = bend_of(knots, columns);
  map.straight_length_m_ = bend > 0 ? spacing_m * straight_spacings(bend) : std::numeric_limits<double>::infinity();
  map.knots_ = std::move(knots);
  return map;
}

double PostMap::next_bend(const Vec2& a, const Vec2& b, double t) const {
  const Vec2 from = (a - area_.min) * per_spacing_;
  const Vec2 along = (b - a) * per_spacing_;
  const double across = next_line(from.x(), along.x(), t);
  const double up = next_line(from.y(), along.y(), t);
  const double diagonal = next_line(from.x() - from.y() + rows_, along.x() - along.y(), t);
  return std::min({across, up, diagonal, 1.0});
}

}  // namespace alate
