#include "study/page/scene_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "out/report/axis.hpp"
#include "out/report/svg.hpp"
#include "study/page/camera.hpp"

namespace alate {

namespace {

constexpr double kWidth = 960;
constexpr double kMargin = 56;
constexpr double kGridStep = 5;

struct Box3 {
  Vec3 min;
  Vec3 max;
};

/// Holds everything drawn; the floor lies on a grid line.
Box3 extent(const Site& site, const std::vector<SceneRoute>& routes) {
  Box3 box{site.mission.start, site.mission.start};
  const auto add = [&](const Vec3& point, double radius) {
    box.min = box.min.cwiseMin(point - Vec3::Constant(radius));
    box.max = box.max.cwiseMax(point + Vec3::Constant(radius));
  };
  add(site.mission.goal, 0);
  for (const Threat& threat : site.threats) add(threat.center, threat.radius_m);
  for (const SceneRoute& each : routes)
    for (const RouteState& state : each.route->states) add(state.position, 0);
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = kGridStep * std::floor(box.min[axis] / kGridStep);
    box.max[axis] = kGridStep * std::ceil(box.max[axis] / kGridStep);
  }
  return box;
}

/// Where a point of space lies on the drawing.
class View {
 public:
  View(const Site& site, const std::vector<SceneRoute>& routes, const Box3& box) {
    for (const double x : {box.min.x(), box.max.x()})
      for (const double y : {box.min.y(), box.max.y()}) include({x, y, box.min.z()}, 0);
    include({box.min.x(), box.min.y(), box.max.z()}, 0);
    include(site.mission.goal, 0);
    for (const Threat& threat : site.threats) include(threat.center, threat.radius_m);
    for (const SceneRoute& each : routes)
      for (const RouteState& state : each.route->states) include(state.position, 0);
  }

  Vec2 operator()(const Vec3& point) const {
    const Vec2 at = camera_.project(point);
    return {kMargin + scale() * (at.x() - low_.x()), kMargin + scale() * (high_.y() - at.y())};
  }
  double length(double units) const { return scale() * units; }
  double height() const { return scale() * (high_.y() - low_.y()) + 2 * kMargin; }
  const Camera& camera() const { return camera_; }

 private:
  double scale() const { return (kWidth - 2 * kMargin) / (high_.x() - low_.x()); }
  void include(const Vec3& point, double radius) {
    low_ = low_.cwiseMin(camera_.project(point) - Vec2::Constant(radius));
    high_ = high_.cwiseMax(camera_.project(point) + Vec2::Constant(radius));
  }

  Camera camera_{radians(150), radians(28)};
  Vec2 low_ = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high_ = -low_;
};

void draw_floor(Svg& svg, const View& view, const Box3& box) {
  const double z = box.min.z();
  for (double x = box.min.x(); x <= box.max.x() + 1e-9; x += kGridStep) {
    svg.line(view({x, box.min.y(), z}), view({x, box.max.y(), z}), "grid");
    svg.text(view({x, box.min.y(), z}) + Vec2{-6, 20}, fmt::format("{:.0f}", x), "tick", Anchor::end);
  }
  for (double y = box.min.y(); y <= box.max.y() + 1e-9; y += kGridStep) {
    svg.line(view({box.min.x(), y, z}), view({box.max.x(), y, z}), "grid");
    svg.text(view({box.max.x(), y, z}) + Vec2{10, 14}, fmt::format("{:.0f}", y), "tick");
  }
  svg.text(view({(box.min.x() + box.max.x()) / 2, box.min.y(), z}) + Vec2{-6, 44}, "x", "axis", Anchor::end);
  svg.text(view({box.max.x(), (box.min.y() + box.max.y()) / 2, z}) + Vec2{40, 30}, "y", "axis");
}

/// The upright scale at the left.
void draw_heights(Svg& svg, const View& view, const Box3& box) {
  const Vec3 foot{box.min.x(), box.min.y(), box.min.z()};
  svg.line(view(foot), view({foot.x(), foot.y(), box.max.z()}), "grid");
  for (double z = box.min.z(); z <= box.max.z() + 1e-9; z += kGridStep) {
    const Vec2 at = view({foot.x(), foot.y(), z});
    svg.line(at, at + Vec2{-6, 0}, "grid");
    if (z > box.min.z()) svg.text(at + Vec2{-10, 5}, fmt::format("{:.0f}", z), "tick", Anchor::end);
  }
  svg.text(view({foot.x(), foot.y(), box.max.z()}) + Vec2{-10, -14}, "z", "axis", Anchor::end);
}

/// Where a great circle lies: two axes of its plane.
struct RingPlane {
  Vec3 u;
  Vec3 v;
};

/// The half of a great circle that faces the viewer, or the other half.
std::vector<Vec2> half_ring(const View& view, const Threat& sphere, const RingPlane& plane, bool front) {
  const auto& [u, v] = plane;
  constexpr int kPieces = 24;
  const Vec3& towards = view.camera().towards();
  const double facing = std::atan2(towards.dot(v), towards.dot(u)) + (front ? 0 : kPi);
  std::vector<Vec2> line;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = facing + kPi * (static_cast<double>(i) / kPieces - 0.5);
    line.push_back(view(sphere.center + sphere.radius_m * (std::cos(angle) * u + std::sin(angle) * v)));
  }
  return line;
}

void draw_rings(Svg& svg, const View& view, const Threat& sphere, bool front) {
  const std::string_view css = front ? "ring" : "ring far";
  svg.polyline(half_ring(view, sphere, {Vec3::UnitX(), Vec3::UnitY()}, front), css);
  svg.polyline(half_ring(view, sphere, {Vec3::UnitX(), Vec3::UnitZ()}, front), css);
  svg.polyline(half_ring(view, sphere, {Vec3::UnitY(), Vec3::UnitZ()}, front), css);
}

/// Light from the upper left: brighter discs, ever smaller and nearer to the light.
void draw_shading(Svg& svg, const Vec2& center, double radius) {
  for (const double share : {0.8, 0.6, 0.42, 0.26})
    svg.circle(center + (1 - share) * radius * Vec2{-0.42, -0.5}, share * radius, "gleam");
}

void draw_sphere(Svg& svg, const View& view, const Threat& sphere) {
  const Vec2 center = view(sphere.center);
  const double radius = view.length(sphere.radius_m);
  draw_rings(svg, view, sphere, false);
  svg.circle(center, radius, "sphere",
             fmt::format("{}: radius {:g}, level {:g}", sphere.name, sphere.radius_m, sphere.level));
  draw_shading(svg, center, radius);
  draw_rings(svg, view, sphere, true);
}

void draw_drop_lines(Svg& svg, const View& view, const SceneRoute& each, double floor) {
  std::vector<Vec2> shadow;
  for (const RouteState& state : each.route->states) {
    const Vec3 below{state.position.x(), state.position.y(), floor};
    shadow.push_back(view(below));
    svg.line(view(state.position), view(below), "drop " + each.css_class);
  }
  svg.polyline(shadow, "shadow " + each.css_class);
}

void draw_leg(Svg& svg, const View& view, const SceneRoute& each, std::size_t i) {
  const Segment leg = each.route->segment(i);
  svg.line(view(leg.a), view(leg.b), "way " + each.css_class);
  svg.circle(view(leg.b), 4, "node " + each.css_class);
}

void draw_end(Svg& svg, const Vec2& at, std::string_view name, double below) {
  svg.circle(at, 8, "end");
  svg.text(at + Vec2{0, below}, name, "label", Anchor::middle);
}

/// Below the spheres, fanned out so that names of spheres at one place stay apart.
void draw_names(Svg& svg, const View& view, const std::vector<Threat>& threats) {
  const double middle = (static_cast<double>(threats.size()) - 1) / 2;
  for (std::size_t i = 0; i < threats.size(); ++i) {
    const double angle = radians(28) * (middle - static_cast<double>(i));
    const double reach = view.length(threats[i].radius_m) + 16;
    svg.text(view(threats[i].center) + reach * Vec2{std::sin(-angle), std::cos(angle)} + Vec2{0, 5}, threats[i].name,
             "label name", Anchor::middle);
  }
}

struct Piece {
  double depth;
  std::function<void()> draw;
};

}  // namespace

std::string scene_svg(const Site& site, const std::vector<SceneRoute>& routes, const std::string& title) {
  const Box3 box = extent(site, routes);
  const View view(site, routes, box);
  Svg svg(kWidth, view.height(), title);
  draw_floor(svg, view, box);
  draw_heights(svg, view, box);
  for (const SceneRoute& each : routes) draw_drop_lines(svg, view, each, box.min.z());

  std::vector<Piece> pieces;
  for (const Threat& threat : site.threats)
    pieces.push_back({view.camera().depth(threat.center), [&] { draw_sphere(svg, view, threat); }});
  for (const SceneRoute& each : routes)
    for (std::size_t i = 1; i < each.route->states.size(); ++i)
      pieces.push_back({view.camera().depth(each.route->segment(i).at(0.5)), [&, i] { draw_leg(svg, view, each, i); }});
  std::ranges::stable_sort(pieces, {}, &Piece::depth);
  for (const Piece& piece : pieces) piece.draw();

  draw_names(svg, view, site.threats);
  draw_end(svg, view(site.mission.start), "Start", 28);
  draw_end(svg, view(site.mission.goal), "Goal", -18);
  svg.circle(view(site.mission.goal), 3.2, "dot");
  return svg.str();
}

}  // namespace alate
