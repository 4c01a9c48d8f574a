#include "out/report/map_layers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "out/report/axis.hpp"
#include "out/report/grid_layer.hpp"
#include "out/route_points.hpp"

namespace alate {

namespace {

std::string extent_of(const Threat& threat) {
  std::string text = fmt::format("{}: radius {:.0f} m", threat.name, threat.radius_m);
  if (threat.core_m > 0) text += fmt::format(", core {:.0f} m", threat.core_m);
  if (threat.shape == Threat::Shape::cylinder)
    text += fmt::format(", from {:.0f} to {:.0f} m", threat.floor_m, threat.top_m);
  return text;
}

/// `above` or below the place, never beyond the sides of the drawing.
void draw_end_label(Svg& svg, const Vec2& at, bool above, std::string_view name) {
  constexpr double kHalfWord = 45;
  constexpr double kLine = 28;
  const double x = std::clamp(at.x(), kHalfWord, svg.width() - kHalfWord);
  const double y = std::clamp(at.y() + (above ? -18 : 34), kLine, svg.height() - kLine / 2);
  svg.text({x, y}, name, "label", Anchor::middle);
}

/// Without ground a grid gives the eye a hold, in frame metres.
void draw_blank(Svg& svg, const MapFrame& map) {
  const Box2& area = map.area;
  svg.rect({0, 0}, {svg.width(), svg.height()}, "blank");
  const double step = round_step((area.max.x() - area.min.x()) / 8);
  for (double x = std::ceil(area.min.x() / step) * step; x < area.max.x(); x += step) {
    const double at = map(Vec2{x, area.min.y()}).x();
    svg.line({at, 0}, {at, svg.height()}, "grid");
    svg.text({at + 4, 18}, fmt::format("x {:.0f} m", x + 0.0), "tick");
  }
  for (double y = std::ceil(area.min.y() / step) * step; y < area.max.y(); y += step) {
    const double at = map(Vec2{area.min.x(), y}).y();
    svg.line({0, at}, {svg.width(), at}, "grid");
    svg.text({4, at - 5}, fmt::format("y {:.0f} m", y + 0.0), "tick");
  }
}

}  // namespace

Hillshade draw_ground(Svg& svg, const MapFrame& map, const Site& site, int columns) {
  Hillshade ground;
  if (site.grid) {
    ground = grid_picture(*site.grid);
    draw_grid(svg, map, *site.grid, ground);
  } else if (site.voxels) {
    const HeightGrid tops = seen_from_above(*site.voxels);
    ground = voxel_picture(tops);
    draw_grid(svg, map, tops, ground);
  } else if (site.has_ground()) {
    ground = hillshade(site, map.area, columns);
    svg.image({0, 0}, {svg.width(), svg.height()}, to_png(ground.image), "relief");
  } else {
    draw_blank(svg, map);
  }
  return ground;
}

void draw_threats(Svg& svg, const MapFrame& map, const Site& site) {
  for (const Threat& threat : site.threats) {
    const Vec2 at = map(threat.center);
    svg.circle(at, threat.radius_m * map.units_per_metre(), "threat", extent_of(threat));
    if (threat.core_m > 0) svg.circle(at, threat.core_m * map.units_per_metre(), "core", extent_of(threat));
  }
}

void draw_threat_names(Svg& svg, const MapFrame& map, const Site& site) {
  for (const Threat& threat : site.threats) {
    const Vec2 at = map(threat.center);
    const bool inside = at.x() > 0 && at.y() > 0 && at.x() < svg.width() && at.y() < svg.height();
    if (inside) svg.text(at + Vec2{0, 5}, threat.name, "label name", Anchor::middle);
  }
}

void draw_route(Svg& svg, const MapFrame& map, const Route& route) {
  if (route.states.size() < 2) return;
  std::vector<Vec2> line;
  for (const Vec3& at : drawn_line(route)) line.push_back(map(at));
  svg.polyline(line, "halo");
  svg.polyline(line, "route");
  // Crowded waypoints, one a cell of a large grid or those along an arc, would paint over the line.
  constexpr double kRoom = 8;
  const auto apart = [&](std::size_t i) {
    return (map(route.states[i].position) - map(route.states[i - 1].position)).norm() >= kRoom;
  };
  for (std::size_t i = 1; i + 1 < route.states.size(); ++i)
    if (apart(i) && apart(i + 1)) svg.circle(map(route.states[i].position), 2.8, "waypoint");
}

void draw_violations(Svg& svg, const MapFrame& map, const Verdict& verdict) {
  for (const Violation& violation : verdict.violations) {
    if (!violation.where.allFinite()) continue;
    const Vec2 at = map(violation.where);
    svg.line(at - Vec2{7, 7}, at + Vec2{7, 7}, "broken");
    svg.line(at - Vec2{7, -7}, at + Vec2{7, -7}, "broken");
  }
}

void draw_ends(Svg& svg, const MapFrame& map, const Mission& mission) {
  const Vec2 start = map(mission.start);
  const Vec2 goal = map(mission.goal);
  const double ring = mission.tolerance_m * map.units_per_metre();
  svg.circle(goal, ring, "tolerance", fmt::format("arrival within {:.0f} m", mission.tolerance_m));
  svg.circle(start, 8, "end");
  svg.circle(start, 4, "dot");
  svg.rect(goal - Vec2{7, 7}, {14, 14}, "end");
  svg.rect(goal - Vec2{3.5, 3.5}, {7, 7}, "dot");
  const bool start_is_upper = start.y() <= goal.y();
  draw_end_label(svg, start, start_is_upper, "Start");
  draw_end_label(svg, goal + Vec2{0, start_is_upper ? ring : -ring}, !start_is_upper, "Goal");
}

}  // namespace alate
