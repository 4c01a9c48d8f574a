#include "check/height_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace alate {

void HeightRange::include(double height_m, const Vec3& where) {
  if (!lowest || height_m < lowest->height_m) lowest = HeightAt{height_m, where};
  if (!highest || height_m > highest->height_m) highest = HeightAt{height_m, where};
}

void HeightRange::include(const HeightRange& other) {
  if (other.lowest) include(other.lowest->height_m, other.lowest->where);
  if (other.highest) include(other.highest->height_m, other.highest->where);
  if (!unknown) unknown = other.unknown;
}

std::optional<Segment> clipped(const Segment& segment, const Box2& box) {
  double enter = 0;
  double leave = 1;
  for (const int axis : {0, 1}) {
    const double from = segment.a[axis];
    const double delta = segment.b[axis] - from;
    if (delta == 0) {
      if (from < box.min[axis] || from > box.max[axis]) return std::nullopt;
      continue;
    }
    const double t1 = (box.min[axis] - from) / delta;
    const double t2 = (box.max[axis] - from) / delta;
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  if (enter > leave) return std::nullopt;
  return Segment{segment.at(enter), segment.at(leave)};
}

namespace {

/// How far outside the outermost posts, in posts, a line may run because of the map's own error.
constexpr double kEdge = 0.002;

/// Shorter pieces of a line only touch a cell's corner.
constexpr double kCorner = 1e-12;

Box2 grown(const Box2& box, double by) { return {box.min - Vec2(by, by), box.max + Vec2(by, by)}; }

/// One straight line through post coordinates, with its height.
struct PostLine {
  const HeightRaster& raster;
  Segment metres;
  Vec2 from;
  Vec2 delta;

  /// Parameters at which the line meets a grid line, sorted, ends included.
  std::vector<double> crossings() const {
    std::vector<double> result{0, 1};
    const std::array<int, 2> posts{raster.columns, raster.rows};
    for (const int axis : {0, 1}) {
      const double first = std::min(from[axis], from[axis] + delta[axis]);
      const double last = std::max(from[axis], from[axis] + delta[axis]);
      const double end = std::min(last, static_cast<double>(posts.at(static_cast<std::size_t>(axis)) - 1));
      for (double line = std::max(0.0, std::ceil(first)); line <= end && delta[axis] != 0; ++line) {
        result.push_back(std::clamp((line - from[axis]) / delta[axis], 0.0, 1.0));
      }
    }
    std::ranges::sort(result);
    return result;
  }

  /// Extremes over [t0, t1], which lies in one cell: height above ground is c0 + c1 t + c2 t^2 there.
  void include_cell(double t0, double t1, HeightRange& range) const {
    const Vec2 middle = from + delta * ((t0 + t1) / 2);
    const Box2 posts{Vec2::Zero(), Vec2(raster.columns - 1, raster.rows - 1)};
    if (!grown(posts, kEdge).contains(middle)) return;
    const int column = std::clamp(static_cast<int>(middle.x()), 0, raster.columns - 2);
    const int row = std::clamp(static_cast<int>(middle.y()), 0, raster.rows - 2);
    const auto post = [&](int right, int down) { return static_cast<double>(raster.post(column + right, row + down)); };
    const double h00 = post(0, 0);
    const double right = post(1, 0) - h00;
    const double down = post(0, 1) - h00;
    const double twist = post(1, 1) - h00 - right - down;
    if (std::isnan(h00 + right + down + twist)) {
      if (!range.unknown) range.unknown = metres.at((t0 + t1) / 2);
      return;
    }
    const Vec2 start = from - Vec2(column, row);
    const auto include = [&](double t) {
      const Vec2 uv = start + delta * t;
      const Vec3 at = metres.at(t);
      range.include(at.z() - (h00 + right * uv.x() + down * uv.y() + twist * uv.x() * uv.y()), at);
    };
    include(t0);
    include(t1);
    const double rise = metres.b.z() - metres.a.z();
    const double c1 =
        rise - right * delta.x() - down * delta.y() - twist * (start.x() * delta.y() + start.y() * delta.x());
    const double c2 = -twist * delta.x() * delta.y();
    const double vertex = c2 == 0 ? t0 : -c1 / (2 * c2);
    if (vertex > t0 && vertex < t1) include(vertex);
  }
};

}  // namespace

HeightRange height_range(const HeightRaster& raster, const Segment& piece) {
  HeightRange range;
  const auto inside = clipped(piece, grown(raster.area, kEdge * raster.cell_m));
  if (!inside || raster.columns < 2 || raster.rows < 2) return range;
  const auto within = [&](const Vec3& p) -> Vec2 {
    return p.head<2>().cwiseMax(raster.area.min).cwiseMin(raster.area.max);
  };
  const Vec2 first = within(inside->a);
  const Vec2 last = within(inside->b);
  double t = 0;
  while (t < 1) {
    const double end = raster.map.straight_until(first, last, t);
    const Segment metres{inside->at(t), inside->at(end)};
    const Vec2 from = raster.map(within(metres.a));
    const PostLine line{raster, metres, from, raster.map(within(metres.b)) - from};
    const std::vector<double> crossings = line.crossings();
    for (std::size_t i = 1; i < crossings.size(); ++i) {
      const bool corner = crossings[i] - crossings[i - 1] < kCorner && crossings.size() > 2;
      if (!corner) line.include_cell(crossings[i - 1], crossings[i], range);
    }
    t = end;
  }
  return range;
}

HeightRange height_range(const Site& site, const Segment& piece) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) return height_range(*raster, piece);
  if (const auto* peaks = std::get_if<PeakGround>(&site.ground)) return height_range(*peaks, piece);
  return {};
}

}  // namespace alate
