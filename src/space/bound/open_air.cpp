#include "space/bound/open_air.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "world/cell_walk.hpp"

namespace alate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Posts. A cell touched by less is left out: its ground there differs from that of its neighbour by far less than
/// kSlack_m.
constexpr double kPostNoise = 1e-6;

/// Cells of a raster: columns and rows, ends excluded.
struct CellBox {
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
};

/// Cells that a rectangle of the frame touches by more than rounding.
CellBox cells_of(const HeightRaster& raster, const Box2& box) {
  const Box2 inside{.min = box.min.cwiseMax(raster.area.min), .max = box.max.cwiseMin(raster.area.max)};
  if (inside.min.x() > inside.max.x() || inside.min.y() > inside.max.y()) return {};
  const std::array<Vec2, 5> corners{inside.min, Vec2(inside.max.x(), inside.min.y()), inside.max,
                                    Vec2(inside.min.x(), inside.max.y()), inside.min};
  // The map is straight between its bends, so it goes furthest at a corner or at a bend of a side.
  Vec2 least = Vec2::Constant(kInfinity);
  Vec2 most = Vec2::Constant(-kInfinity);
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec2 way = corners[side + 1] - corners[side];
    for (double t = 0; t < 1; t = raster.map.straight_until(corners[side], corners[side + 1], t)) {
      const Vec2 at = raster.map(corners[side] + t * way);
      least = least.cwiseMin(at);
      most = most.cwiseMax(at);
    }
  }
  const auto first = [](double at, int cells) {
    return static_cast<int>(std::clamp(std::floor(at + kPostNoise), 0.0, double(cells)));
  };
  const auto end = [](double at, int cells) {
    return static_cast<int>(std::clamp(std::ceil(at - kPostNoise), 0.0, double(cells)));
  };
  return {.first_column = first(least.x(), raster.columns - 1),
          .end_column = end(most.x(), raster.columns - 1),
          .first_row = first(least.y(), raster.rows - 1),
          .end_row = end(most.y(), raster.rows - 1)};
}

constexpr GroundRange kNothing{.low = kInfinity, .high = -kInfinity};

void widen(double low, double high, GroundRange& range) {
  range.low = std::min(range.low, low);
  range.high = std::max(range.high, high);
}

GroundRange range_over(const HeightRaster& raster, const Box2& box) {
  GroundRange range = kNothing;
  const CellBox cells = cells_of(raster, box);
  for (int row = cells.first_row; row < cells.end_row; ++row) {
    for (int column = cells.first_column; column < cells.end_column; ++column) {
      const std::array<float, 4> corners{raster.post(column, row), raster.post(column + 1, row),
                                         raster.post(column, row + 1), raster.post(column + 1, row + 1)};
      if (std::ranges::any_of(corners, [](float post) { return std::isnan(post); })) {
        range.has_voids = true;
      } else {
        const auto [low, high] = std::ranges::minmax(corners);
        widen(double{low}, double{high}, range);
      }
    }
  }
  return range;
}

/// From where a walk through a raster stands to its exit from the cell: a quadratic, at most a quarter of its
/// curvature off its chord.
void widen_by_cell(const HeightRaster& raster, const CellWalk& walk, const CellWalk::Exit& exit, GroundRange& range) {
  const auto h = double{raster.post(walk.column, walk.row)};
  const double b = double{raster.post(walk.column + 1, walk.row)} - h;
  const double c = double{raster.post(walk.column, walk.row + 1)} - h;
  const double d = double{raster.post(walk.column + 1, walk.row + 1)} - h - b - c;
  const double u = walk.x + walk.dx * walk.t - walk.column;
  const double v = walk.y + walk.dy * walk.t - walk.row;
  const double part = exit.t - walk.t;
  const double curve = walk.dx * walk.dy * d * part * part;
  const double from = h + u * b + v * (c + u * d);
  const double to = from + part * (walk.dx * (b + v * d) + walk.dy * (c + u * d)) + curve;
  if (std::isnan(curve)) {
    range.has_voids = true;
  } else {
    widen(std::min(from, to) - std::abs(curve) / 4, std::max(from, to) + std::abs(curve) / 4, range);
  }
}

/// Parts outside the posts are left out.
GroundRange range_along(const HeightRaster& raster, const Vec2& a, const Vec2& b) {
  GroundRange range = kNothing;
  const auto inside = [&](const Vec2& p) { return Vec2(p.cwiseMax(raster.area.min).cwiseMin(raster.area.max)); };
  const auto clipped = [&](const Vec2& p) {
    return Vec2(p.cwiseMax(Vec2::Zero()).cwiseMin(Vec2(raster.columns - 1, raster.rows - 1)));
  };
  const Vec2 begin = inside(a);
  const Vec2 way = inside(b) - begin;
  for (double t = 0; t < 1;) {
    const double t_to = raster.map.straight_until(begin, begin + way, t);
    const Vec2 from = raster.map(inside(begin + t * way));
    const Vec2 to = raster.map(inside(begin + t_to * way));
    CellWalk walk({.from = clipped(from), .to = clipped(to)}, raster.columns - 1, raster.rows - 1);
    for (bool on = true; on;) {
      const CellWalk::Exit exit = walk.exit(0);
      widen_by_cell(raster, walk, exit, range);
      on = walk.step(exit);
    }
    t = t_to;
  }
  return range;
}

/// Of hills over a disc.
GroundRange range_around(const PeakGround& hills, const Vec2& middle, double radius_m) {
  const double height = hills.height(middle);
  const double most = hills.steepness() * radius_m;
  return {.low = height - most, .high = height + most};
}

double distance_to_farthest_corner(const Box2& box, const Vec2& point) {
  return (point - box.min).cwiseAbs().cwiseMax((box.max - point).cwiseAbs()).norm();
}

/// Altitudes that a core closes everywhere within `farthest_m` of its axis; empty if none.
Altitudes closed_by(const Threat& threat, double farthest_m) {
  const double reach = threat.core_m - OpenAir::kSlack_m;
  if (threat.core_m <= 0 || farthest_m >= reach) return {.low = kInfinity, .high = -kInfinity};
  if (threat.shape == Threat::Shape::cylinder)
    return {.low = threat.floor_m + OpenAir::kSlack_m, .high = threat.top_m - OpenAir::kSlack_m};
  const double half = std::sqrt(reach * reach - farthest_m * farthest_m);
  return {.low = threat.center.z() - half, .high = threat.center.z() + half};
}

double slope(const std::optional<double>& limit_rad) {
  return limit_rad && *limit_rad < kPi / 2 ? std::tan(*limit_rad) * (1 + 1e-9) : kInfinity;
}

}  // namespace

Box2 OpenAir::area() const {
  const auto* raster = std::get_if<HeightRaster>(&site_.ground);
  return raster != nullptr ? raster->area : std::get<PeakGround>(site_.ground).area;
}

Altitudes OpenAir::open_above(const GroundRange& ground) const {
  const Band& band = site_.band;
  Altitudes open{.low = ground.low + band.clearance_m - kSlack_m,
                 .high = band.ceiling_agl_m ? ground.high + *band.ceiling_agl_m + kSlack_m : kInfinity};
  if (ground.low > ground.high) open.high = -kInfinity;
  if (ground.has_voids && voids_ == Voids::open) open = {.low = -kInfinity, .high = kInfinity};
  if (band.ceiling_amsl_m) open.high = std::min(open.high, *band.ceiling_amsl_m + kSlack_m);
  return open;
}

template <class Farthest>
void OpenAir::close_cores(const Farthest& farthest, Altitudes& open) const {
  for (const Threat& threat : site_.threats) {
    const Altitudes closed = closed_by(threat, farthest(threat.center.head<2>()));
    if (!closed.any()) continue;
    if (closed.low <= open.low && closed.high >= open.low) open.low = closed.high;
    if (closed.low <= open.high && closed.high >= open.high) open.high = closed.low;
  }
}

Altitudes OpenAir::over(const Box2& box) const {
  const auto* raster = std::get_if<HeightRaster>(&site_.ground);
  Altitudes open =
      open_above(raster != nullptr ? range_over(*raster, box)
                                   : range_around(std::get<PeakGround>(site_.ground), (box.min + box.max) / 2,
                                                  (box.max - box.min).norm() / 2));
  close_cores([&](const Vec2& center) { return distance_to_farthest_corner(box, center); }, open);
  return open;
}

Altitudes OpenAir::along(const Vec2& a, const Vec2& b) const {
  const auto* raster = std::get_if<HeightRaster>(&site_.ground);
  Altitudes open =
      open_above(raster != nullptr ? range_along(*raster, a, b)
                                   : range_around(std::get<PeakGround>(site_.ground), (a + b) / 2, (b - a).norm() / 2));
  close_cores([&](const Vec2& center) { return std::max((center - a).norm(), (center - b).norm()); }, open);
  return open;
}

SlopeLimits optimistic_slopes(const Vehicle& vehicle) {
  return {.climb = slope(vehicle.climb_rad), .descent = slope(vehicle.descent_rad)};
}

double distance_to(const Box2& box, const Vec2& point) {
  return (point - point.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

}  // namespace alate
