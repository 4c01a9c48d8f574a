#include "study/page/terrain_view.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"
#include "study/page/camera.hpp"

namespace alate {

namespace {

constexpr double kWidth = 960;
constexpr double kMargin = 44;
constexpr int kShades = 9;

/// Corners of the cells, and the picture's camera.
class Land {
 public:
  explicit Land(const TerrainPicture& picture)
      : cells_(picture.cells), exaggeration_(picture.exaggeration), area_(picture.area) {
    for (int row = 0; row <= cells_; ++row) {
      for (int column = 0; column <= cells_; ++column) {
        const Vec2 at = area_.min + (area_.max - area_.min).cwiseProduct(Vec2(column, row)) / cells_;
        corners_.push_back(raised({at.x(), at.y(), picture.world.height(at).value_or(0)}));
        include(corners_.back());
      }
    }
  }

  int cells() const { return cells_; }
  const Box2& area() const { return area_; }
  const Vec3& corner(int row, int column) const {
    const int index = row * (cells_ + 1) + column;
    return corners_[static_cast<std::size_t>(index)];
  }
  Vec3 raised(const Vec3& place) const { return {place.x(), place.y(), exaggeration_ * place.z()}; }
  void include(const Vec3& point) {
    low_ = low_.cwiseMin(camera_.project(point));
    high_ = high_.cwiseMax(camera_.project(point));
  }
  Vec2 operator()(const Vec3& raised) const {
    const Vec2 at = camera_.project(raised);
    return {kMargin + scale() * (at.x() - low_.x()), kMargin + scale() * (high_.y() - at.y())};
  }
  double height() const { return scale() * (high_.y() - low_.y()) + 2 * kMargin; }
  /// How near a place is to the viewer, its height left out: nearer ground is drawn over farther ground.
  double nearness(const Vec3& at) const { return camera_.depth({at.x(), at.y(), 0}); }
  double cell_nearness() const { return camera_.depth(Vec3(corner(1, 1) - corner(0, 0))); }

 private:
  double scale() const { return (kWidth - 2 * kMargin) / (high_.x() - low_.x()); }

  Camera camera_{radians(150), radians(38)};
  int cells_;
  double exaggeration_;
  Box2 area_;
  std::vector<Vec3> corners_;
  Vec2 low_ = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high_ = -low_;
};

/// 0 (dark) to kShades - 1, lit from the left and behind the viewer.
int shade_of(const Vec3& normal) {
  const Vec3 light = Vec3(-0.75, -0.25, 0.9).normalized();
  const double flat = light.z();
  const double lit = std::clamp(0.5 + 0.75 * (normal.dot(light) - flat), 0.0, 1.0);
  return static_cast<int>(std::lround(lit * (kShades - 1)));
}

struct Piece {
  double nearness = 0;
  std::vector<Vec2> points;
  std::string css_class;
  bool is_leg = false;
};

Piece cell_piece(const Land& land, int row, int column) {
  const std::array<Vec3, 4> corners{land.corner(row, column), land.corner(row, column + 1),
                                    land.corner(row + 1, column + 1), land.corner(row + 1, column)};
  const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).normalized();
  Piece piece{.nearness = land.nearness((corners[0] + corners[2]) / 2),
              .points = {},
              .css_class = fmt::format("land s{}", shade_of(normal))};
  for (const Vec3& corner : corners) piece.points.push_back(land(corner));
  return piece;
}

/// Legs come after all cells below them.
Piece leg_piece(const Land& land, const SceneRoute& each, std::size_t i) {
  const Segment leg = each.route->segment(i);
  const Vec3 a = land.raised(leg.a);
  const Vec3 b = land.raised(leg.b);
  return {.nearness = std::max(land.nearness(a), land.nearness(b)) + std::abs(land.cell_nearness()),
          .points = {land(a), land(b)},
          .css_class = "over " + each.css_class,
          .is_leg = true};
}

std::vector<Piece> pieces_of(const Land& land, const std::vector<SceneRoute>& routes) {
  std::vector<Piece> pieces;
  for (int row = 0; row < land.cells(); ++row)
    for (int column = 0; column < land.cells(); ++column) pieces.push_back(cell_piece(land, row, column));
  for (const SceneRoute& each : routes)
    for (std::size_t i = 1; i < each.route->states.size(); ++i) pieces.push_back(leg_piece(land, each, i));
  std::ranges::stable_sort(pieces, {}, &Piece::nearness);
  return pieces;
}

void draw_ticks(Svg& svg, const Land& land) {
  constexpr double kKm = 1000;
  const Box2& area = land.area();
  for (const double x : ticks(area.min.x() / kKm, area.max.x() / kKm, 6))
    svg.text(land({kKm * x, area.min.y(), 0}) + Vec2{-6, 22}, fmt::format("{:g}", x), "tick", Anchor::end);
  for (const double y : ticks(area.min.y() / kKm, area.max.y() / kKm, 6))
    svg.text(land({area.max.x(), kKm * y, 0}) + Vec2{10, 14}, fmt::format("{:g}", y), "tick");
  const Vec2 middle = (area.min + area.max) / 2;
  svg.text(land({middle.x(), area.min.y(), 0}) + Vec2{-30, 40}, "x, km", "axis", Anchor::end);
  svg.text(land({area.max.x(), middle.y(), 0}) + Vec2{44, 26}, "y, km", "axis");
}

void draw_hidden(Svg& svg, const Land& land, const SceneRoute& each) {
  std::vector<Vec2> line;
  for (const RouteState& state : each.route->states) line.push_back(land(land.raised(state.position)));
  svg.polyline(line, "shadow " + each.css_class);
}

void draw_end(Svg& svg, const Vec2& at, std::string_view name) {
  svg.circle(at, 7, "end");
  svg.text(at + Vec2{0, -16}, name, "label", Anchor::middle);
}

}  // namespace

std::string terrain_svg(const TerrainPicture& picture, const std::vector<SceneRoute>& routes,
                        const std::string& title) {
  Land land(picture);
  for (const SceneRoute& each : routes)
    for (const RouteState& state : each.route->states) land.include(land.raised(state.position));
  Svg svg(kWidth, land.height(), title);
  for (const Piece& piece : pieces_of(land, routes)) {
    if (piece.is_leg)
      svg.line(piece.points.front(), piece.points.back(), piece.css_class);
    else
      svg.polygon(piece.points, piece.css_class);
  }
  for (const SceneRoute& each : routes) draw_hidden(svg, land, each);
  draw_ticks(svg, land);
  draw_end(svg, land(land.raised(picture.world.site().mission.start)), "Start");
  draw_end(svg, land(land.raised(picture.world.site().mission.goal)), "Goal");
  return svg.str();
}

const std::string_view kTerrainStyle = R"css(
svg .land { fill: currentColor; stroke: currentColor; stroke-width: .7; stroke-linejoin: round; }
svg .s0 { color: color-mix(in srgb, var(--ground) 42%, #1b1712); }
svg .s1 { color: color-mix(in srgb, var(--ground) 58%, #1b1712); }
svg .s2 { color: color-mix(in srgb, var(--ground) 74%, #1b1712); }
svg .s3 { color: color-mix(in srgb, var(--ground) 88%, #1b1712); }
svg .s4 { color: var(--ground); }
svg .s5 { color: color-mix(in srgb, var(--ground) 86%, #fffaf0); }
svg .s6 { color: color-mix(in srgb, var(--ground) 70%, #fffaf0); }
svg .s7 { color: color-mix(in srgb, var(--ground) 54%, #fffaf0); }
svg .s8 { color: color-mix(in srgb, var(--ground) 38%, #fffaf0); }
svg .over { stroke: var(--line); stroke-width: 4; stroke-linecap: round; }
svg .over.w1 { stroke-linecap: butt; stroke-dasharray: 8 4; }
svg .over.w2 { stroke-dasharray: 1 7; stroke-width: 5; }
)css";

}  // namespace alate
