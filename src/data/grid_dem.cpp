#include "data/grid_dem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "data/limits.hpp"

namespace alate {

namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Where a square of the frame lies among the posts. The map bends at the sides of its triangles only, so the bends of
/// the square's sides are the corners of its image.
Box2 post_box(const PostMap& map, const Box2& square) {
  const auto& [low, high] = square;
  const std::array<Vec2, 5> ring{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y()), low};
  const Vec2 first = map(low);
  Box2 box{first, first};
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec2& from = ring.at(side);
    const Vec2& to = ring.at(side + 1);
    for (double t = 0; t < 1;) {
      t = map.straight_until(from, to, t);
      const Vec2 at = map(from + t * (to - from));
      box = {box.min.cwiseMin(at), box.max.cwiseMax(at)};
    }
  }
  return box;
}

/// Of the posts around `box`; NaN where one is void or missing.
float highest_post(const HeightRaster& raster, const Box2& box) {
  constexpr double kRounding = 1e-6;  // posts
  const Vec2 last(raster.columns - 1, raster.rows - 1);
  const Box2 covered{Vec2::Constant(-kRounding), last + Vec2::Constant(kRounding)};
  if (!covered.contains(box.min) || !covered.contains(box.max)) return kUnknown;
  const Eigen::Vector2i low = box.min.cwiseMax(0).array().floor().cast<int>();
  const Eigen::Vector2i high = box.max.cwiseMin(last).array().ceil().cast<int>();
  float highest = -std::numeric_limits<float>::infinity();
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const float post = raster.post(column, row);
      if (std::isnan(post)) return kUnknown;
      highest = std::max(highest, post);
    }
  }
  return highest;
}

/// Columns and rows, and the least side of a cell that a grid has room for.
bool fits(const Vec2& count, const Vec2& size, double cell_m, SiteFaults& faults) {
  if (count.minCoeff() < 1) {
    faults.add({.field = "grid.cell_m",
                .value = fmt::format("{}", cell_m),
                .limit = fmt::format("<= {:.0f}", std::floor(size.minCoeff() / 2)),
                .unit = "m",
                .message = "no whole cell lies within the terrain"});
    return false;
  }
  if (count.maxCoeff() <= kMaxGridSide && count.prod() <= kMaxGridCells) return true;
  const double least =
      std::max(size.maxCoeff() / kMaxGridSide, std::sqrt(size.prod() / static_cast<double>(kMaxGridCells)));
  faults.add({.field = "grid.cell_m",
              .value = fmt::format("{}", cell_m),
              .limit = fmt::format(">= {:.2f}", std::ceil(100 * least) / 100),
              .unit = "m",
              .message = fmt::format("cuts the terrain into {:.0f} x {:.0f} cells; a grid has {} columns, {} rows and "
                                     "{} cells at most",
                                     count.x(), count.y(), kMaxGridSide, kMaxGridSide, kMaxGridCells)});
  return false;
}

}  // namespace

std::optional<HeightGrid> cut_grid(const HeightRaster& raster, const GridSpec& spec, SiteFaults& faults) {
  const double cell_m = spec.cell_m;
  const Vec2 first = (raster.area.min / cell_m).array().ceil();
  const Vec2 last = (raster.area.max / cell_m).array().floor();
  const Vec2 count = (last - first).cwiseMax(0);
  if (!fits(count, raster.area.max - raster.area.min, cell_m, faults)) return std::nullopt;
  HeightGrid grid{.columns = static_cast<int>(count.x()),
                  .rows = static_cast<int>(count.y()),
                  .cell_m = cell_m,
                  .origin = first * cell_m,
                  .level_m = spec.level_amsl_m.value_or(0),
                  .blocked = {},
                  .height_m = {}};
  const Vec2 half = Vec2::Constant(cell_m / 2);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 center = grid.center(column, row).head<2>();
      const float height = highest_post(raster, post_box(raster.map, {center - half, center + half}));
      const bool free = double{height} + spec.clearance_m < grid.level_m;  // false for NaN
      grid.height_m.push_back(height);
      grid.blocked.push_back(free ? 0 : 1);
    }
  }
  return grid;
}

}  // namespace alate
