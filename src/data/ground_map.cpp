#include "data/ground_map.hpp"

#include <gdal.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <vector>

namespace alate {

namespace {

constexpr double kLatticeError = 0.0009;  ///< Posts.
constexpr std::size_t kMostKnots = 4'000'000;

struct TransformDeleter {
  void operator()(OGRCoordinateTransformation* transform) const { OCTDestroyCoordinateTransformation(transform); }
};
using Transform = std::unique_ptr<OGRCoordinateTransformation, TransformDeleter>;

/// Projects all points in place; false if any has no image.
bool apply(OGRCoordinateTransformation& transform, std::vector<Vec2>& points) {
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    x[i] = points[i].x();
    y[i] = points[i].y();
  }
  transform.Transform(static_cast<int>(points.size()), x.data(), y.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {x[i], y[i]};
    if (!points[i].allFinite()) return false;
  }
  return true;
}

/// Projects between frame metres and post coordinates, exactly and slowly.
class Projector {
 public:
  Projector(const RasterGrid& grid, const OGRSpatialReference* frame_crs) : forward_(grid.geotransform) {
    [[maybe_unused]] const int invertible = GDALInvGeoTransform(forward_.data(), inverse_.data());
    assert(invertible != 0);
    if (frame_crs == nullptr) return;
    to_source_.reset(OGRCreateCoordinateTransformation(frame_crs, &grid.crs));
    to_frame_.reset(OGRCreateCoordinateTransformation(&grid.crs, frame_crs));
    if (grid.crs.IsGeographic() != 0) turn_ = 2 * kPi / grid.crs.GetAngularUnits();
    middle_x_ = source({0.5 * (grid.columns - 1), 0.5 * (grid.rows - 1)}).x();
  }

  bool exists() const { return to_source_ && to_frame_; }

  bool to_frame(std::vector<Vec2>& points) const {
    for (Vec2& point : points) point = source(point);
    return !to_frame_ || apply(*to_frame_, points);
  }

  bool to_posts(std::vector<Vec2>& points) const {
    if (to_source_ && !apply(*to_source_, points)) return false;
    for (Vec2& point : points) {
      // A raster may count longitudes beyond 180 degrees.
      if (turn_ > 0) point.x() = middle_x_ + std::remainder(point.x() - middle_x_, turn_);
      point = post(point);
    }
    return true;
  }

  /// Source CRS -> post coordinates, as PostMap::affine takes it.
  std::array<double, 6> affine() const {
    return {inverse_[0] - 0.5, inverse_[1], inverse_[2], inverse_[3] - 0.5, inverse_[4], inverse_[5]};
  }

 private:
  Vec2 source(const Vec2& post) const {
    const double column = post.x() + 0.5;
    const double row = post.y() + 0.5;
    return {forward_[0] + column * forward_[1] + row * forward_[2],
            forward_[3] + column * forward_[4] + row * forward_[5]};
  }
  Vec2 post(const Vec2& source) const {
    return {inverse_[0] - 0.5 + source.x() * inverse_[1] + source.y() * inverse_[2],
            inverse_[3] - 0.5 + source.x() * inverse_[4] + source.y() * inverse_[5]};
  }

  std::array<double, 6> forward_;
  std::array<double, 6> inverse_{};
  Transform to_source_;  ///< Both empty: the frame is the source's own.
  Transform to_frame_;
  double turn_ = 0;  ///< A full circle of a geographic source, in its unit.
  double middle_x_ = 0;
};

/// Posts along the border, corners included; enough that no bulge between two of them counts.
std::vector<Vec2> border(const RasterGrid& grid) {
  constexpr int kSteps = 64;
  const double right = grid.columns - 1;
  const double bottom = grid.rows - 1;
  std::vector<Vec2> points;
  for (int i = 0; i <= kSteps; ++i) {
    const double part = static_cast<double>(i) / kSteps;
    points.insert(points.end(),
                  {{part * right, 0}, {part * right, bottom}, {0, part * bottom}, {right, part * bottom}});
  }
  return points;
}

Box2 box_around(const std::vector<Vec2>& points) {
  Box2 box{points.front(), points.front()};
  for (const Vec2& point : points) {
    box.min = box.min.cwiseMin(point);
    box.max = box.max.cwiseMax(point);
  }
  return box;
}

std::optional<double> cell_size(const RasterGrid& grid, const Projector& projector) {
  const Vec2 middle{grid.columns / 2, grid.rows / 2};
  std::vector<Vec2> posts{middle, middle - Vec2{1, 0}, middle - Vec2{0, 1}};
  if (!projector.to_frame(posts)) return std::nullopt;
  return 0.5 * ((posts[1] - posts[0]).norm() + (posts[2] - posts[0]).norm());
}

struct Lattice {
  Box2 area;
  double spacing_m = 0;
  int columns = 0;
  int rows = 0;
  std::vector<Vec2> knots;

  PostMap map() const { return PostMap::lattice(area, spacing_m, columns, knots); }
  bool project(const Projector& projector) {
    knots.clear();
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) knots.emplace_back(area.min + spacing_m * Vec2{i, j});
    return projector.to_posts(knots);
  }
};

/// The same area with half the spacing.
Lattice halved(const Lattice& coarse) {
  return {.area = coarse.area,
          .spacing_m = coarse.spacing_m / 2,
          .columns = 2 * coarse.columns - 1,
          .rows = 2 * coarse.rows - 1,
          .knots = {}};
}

/// Largest error of `map` at the knots of a finer lattice.
double error_at(const PostMap& map, const Lattice& finer) {
  double error = 0;
  for (int j = 0; j < finer.rows; ++j) {
    for (int i = 0; i < finer.columns; ++i) {
      const Vec2 exact = finer.knots[static_cast<std::size_t>(j) * static_cast<std::size_t>(finer.columns) +
                                     static_cast<std::size_t>(i)];
      error = std::max(error, (map(finer.area.min + finer.spacing_m * Vec2{i, j}) - exact).norm());
    }
  }
  return error;
}

std::optional<PostMap> fit_lattice(const Box2& area, double margin_m, const Projector& projector) {
  constexpr int kFirstKnots = 5;
  const Vec2 margin = Vec2::Constant(margin_m);
  Lattice coarse;
  coarse.area = {area.min - margin, area.max + margin};
  const Vec2 size = coarse.area.max - coarse.area.min;
  coarse.spacing_m = size.maxCoeff() / (kFirstKnots - 1);
  coarse.columns = std::max(3, static_cast<int>(std::ceil(size.x() / coarse.spacing_m)) + 1);
  coarse.rows = std::max(3, static_cast<int>(std::ceil(size.y() / coarse.spacing_m)) + 1);
  coarse.area.max = coarse.area.min + coarse.spacing_m * Vec2{coarse.columns - 1, coarse.rows - 1};
  if (!coarse.project(projector)) return std::nullopt;
  while (4 * coarse.knots.size() < kMostKnots) {
    Lattice finer = halved(coarse);
    if (!finer.project(projector)) return std::nullopt;
    PostMap map = coarse.map();
    if (error_at(map, finer) < kLatticeError) return map;
    coarse = std::move(finer);
  }
  return std::nullopt;
}

}  // namespace

std::optional<GroundMap> map_ground(const RasterGrid& grid, const Frame& frame) {
  OGRSpatialReference frame_crs;
  bool same = frame.is_local() || grid.crs.IsEmpty();
  if (!same) {
    if (frame_crs.SetFromUserInput(frame.name().c_str()) != OGRERR_NONE) return std::nullopt;
    frame_crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    same = frame_crs.IsSame(&grid.crs) != 0;
  }
  const Projector projector(grid, same ? nullptr : &frame_crs);
  if (!same && !projector.exists()) return std::nullopt;
  std::vector<Vec2> outline = border(grid);
  const auto cell_m = cell_size(grid, projector);
  if (!projector.to_frame(outline) || !cell_m) return std::nullopt;
  const Box2 area = box_around(outline);
  auto map = same ? PostMap::affine(projector.affine()) : fit_lattice(area, *cell_m, projector);
  if (!map) return std::nullopt;
  return GroundMap{.map = std::move(*map), .area = area, .cell_m = *cell_m};
}

}  // namespace alate
