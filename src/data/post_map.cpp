#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "alate/data/height_raster.hpp"

namespace alate {

namespace {

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
  return map;
}

PostMap PostMap::lattice(const Box2& area, double spacing_m, int columns, std::vector<Vec2> knots) {
  assert(columns >= 2 && knots.size() >= 2 * static_cast<std::size_t>(columns));
  PostMap map;
  map.area_ = area;
  map.per_spacing_ = 1 / spacing_m;
  map.columns_ = columns;
  map.rows_ = static_cast<int>(knots.size()) / columns;
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
