#include "out/report/map_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include "out/report/axis.hpp"
#include "out/report/grid_layer.hpp"
#include "out/report/hillshade.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/map_layers.hpp"
#include "out/report/number_words.hpp"
#include "out/report/point_layer.hpp"
#include "out/report/svg.hpp"
#include "out/route_points.hpp"
#include "out/text.hpp"

namespace alate {

namespace {

constexpr double kWidth = 1000;
constexpr int kPictureColumns = 800;

bool leaves_band(const Site& site, const Vec3& at) {
  const Band& band = site.band;
  if (band.ceiling_amsl_m && at.z() > *band.ceiling_amsl_m) return true;
  if (!site.has_ground()) return false;
  const auto above = height_above_ground(site, at);
  return !above || *above < band.clearance_m || (band.ceiling_agl_m && *above > *band.ceiling_agl_m);
}

bool in_blocked_cell(const HeightGrid& grid, const Vec3& at) {
  const auto cell = grid.cell_at(at.head<2>());
  return cell && grid.blocked_at((*cell)[0], (*cell)[1]);
}

bool in_blocked_cell(const VoxelGrid& voxels, const Vec3& at) {
  const auto cell = voxels.cell_at(at);
  return cell && voxels.blocked_at(*cell);
}

/// May the straight flight from start to goal not pass here: outside the band, over unknown ground, in a core or in a
/// blocked cell?
bool is_barred(const Site& site, const Vec3& at) {
  if (leaves_band(site, at) || (site.grid && in_blocked_cell(*site.grid, at))) return true;
  if (site.voxels && in_blocked_cell(*site.voxels, at)) return true;
  return std::ranges::any_of(site.threats, [&](const Threat& threat) {
    const bool sphere = threat.shape == Threat::Shape::sphere;
    const double distance = sphere ? (at - threat.center).norm() : (at - threat.center).head<2>().norm();
    const bool at_height = sphere || (at.z() >= threat.floor_m && at.z() <= threat.top_m);
    return at_height && distance < threat.core_m;
  });
}

/// The straight line from start to goal, thick where it is barred. Returns whether any of it is.
bool draw_direct_line(Svg& svg, const MapFrame& map, const Site& site) {
  constexpr int kPieces = 400;
  const Segment direct{site.mission.start, site.mission.goal};
  svg.line(map(direct.a), map(direct.b), "direct");
  bool barred = false;
  std::vector<Vec2> piece;
  for (int i = 0; i <= kPieces + 1; ++i) {
    const Vec3 at = direct.at(std::min(1.0, static_cast<double>(i) / kPieces));
    if (i <= kPieces && is_barred(site, at)) {
      piece.push_back(map(at));
      continue;
    }
    if (piece.size() > 1) {
      svg.polyline(piece, "barred");
      barred = true;
    }
    piece.clear();
  }
  return barred;
}

/// The corner plate that carries scale bar and north arrow lies where least is drawn.
Vec2 free_corner(const Svg& svg, const MapFrame& map, const Result& result, const Vec2& plate) {
  std::vector<Vec2> drawn{map(result.site.mission.start), map(result.site.mission.goal)};
  for (const RouteState& state : result.plan.route.states) drawn.push_back(map(state.position));
  for (const Threat& threat : result.site.threats) drawn.push_back(map(threat.center));
  const Vec2 far{svg.width() - plate.x(), svg.height() - plate.y()};
  const std::array<Vec2, 4> corners{Vec2{0, far.y()}, far, Vec2{0, 0}, Vec2{far.x(), 0}};
  const auto room = [&](const Vec2& corner) {
    const Vec2 middle = corner + plate / 2;
    return std::ranges::min(drawn | std::views::transform([&](const Vec2& p) { return (p - middle).norm(); }));
  };
  return *std::ranges::max_element(corners, {}, room);
}

void draw_scale_and_north(Svg& svg, const MapFrame& map, const Result& result) {
  const double metres = round_step(svg.width() / map.units_per_metre() / 9);
  const double length = metres * map.units_per_metre();
  const Vec2 plate{length + 110, 76};
  const Vec2 corner = free_corner(svg, map, result, plate);
  svg.rect(corner, plate, "plate");
  const Vec2 left = corner + Vec2{24, 54};
  svg.line(left, left + Vec2{length, 0}, "scale");
  svg.line(left - Vec2{0, 6}, left + Vec2{0, 6}, "scale");
  svg.line(left + Vec2{length, -6}, left + Vec2{length, 6}, "scale");
  const std::string label = metres >= 1000 ? fmt::format("{} km", metres / 1000) : fmt::format("{} m", metres);
  svg.text(left + Vec2{length / 2, -14}, label, "plain", Anchor::middle);
  const Vec2 tip = corner + Vec2{length + 66, 10};
  svg.polygon({tip, tip + Vec2{9, 26}, tip + Vec2{0, 20}, tip + Vec2{-9, 26}}, "north", "grid north");
  svg.text(tip + Vec2{0, 54}, "N", "plain", Anchor::middle);
}

std::string key(std::string_view swatch, std::string_view text) {
  return fmt::format("<li><span class=\"swatch {}\"></span>{}</li>\n", swatch, text);
}

struct Shown {
  const Result& result;
  const MapFrame& map;
  const Hillshade& ground;
  bool barred = false;  ///< Is the straight line?
};

std::ptrdiff_t threats_outside(const Shown& shown) {
  return std::ranges::count_if(shown.result.site.threats, [&](const Threat& threat) {
    const Vec2 center = threat.center.head<2>();
    const Box2& area = shown.map.area;
    return (center - center.cwiseMax(area.min).cwiseMin(area.max)).norm() > threat.radius_m;
  });
}

std::string legend(const Shown& shown) {
  const Site& site = shown.result.site;
  std::string items;
  if (!shown.result.plan.route.empty()) items += key("s-route", "Route");
  items += key("s-direct", "Straight line");
  if (shown.barred) items += key("s-barred", "Straight line where it is not allowed");
  items += points_key(shown.map, site);
  if (!site.threats.empty()) items += key("s-threat", "Threat: flying inside costs");
  if (std::ranges::any_of(site.threats, [](const Threat& t) { return t.core_m > 0; }))
    items += key("s-core", "Core: must not be entered");
  if (site.grid) items += key("s-blocked", "Blocked cell");
  const char* heights = site.voxels ? "Top of the highest blocked cell from, m:" : "Ground from, m:";
  if (!shown.ground.bands.empty()) items += height_key(shown.ground, heights);
  if (shown.ground.has_unknown) items += key("s-unknown", "Ground not known");
  if (!shown.result.plan.route.empty() && !shown.result.verdict.violations.empty())
    items += key("s-broken", "Place where a rule is broken");
  if (const auto outside = threats_outside(shown); outside > 0)
    items += fmt::format("<li>{} {} outside this map</li>\n", outside, outside == 1 ? "threat lies" : "threats lie");
  return fmt::format("<ul class=\"key\">\n{}</ul>\n", items);
}

/// Why the route is as it is, in a sentence.
std::string caption(const Shown& shown) {
  const Result& result = shown.result;
  if (result.plan.route.empty() || !result.verdict.ok()) return {};
  std::string text = shown.barred ? "The straight line is not allowed; the route goes round" : "The route";
  if (const auto& lowest = result.metrics.min_clearance_m)
    text += fmt::format("{} stays {} or more above the ground", shown.barred ? " and" : "", quantity(*lowest, "m"));
  const auto core = std::ranges::find(result.verdict.margins, "threat_core", &Margin::rule);
  const bool has_core = core != result.verdict.margins.end() && std::isfinite(core->margin);
  if (has_core) text += fmt::format(" and keeps {} away from every core", quantity(core->margin, "m"));
  if (!has_core && !result.metrics.min_clearance_m && !shown.barred) return {};
  return fmt::format("<p class=\"caption\">{}.</p>\n", xml_escape(text));
}

}  // namespace

std::string map_figure(const Result& result) {
  const Site& site = result.site;
  const Route& route = result.plan.route;
  const MapFrame map = map_frame(site, route, kWidth);
  Svg svg(kWidth, map.height(), "Map of the ground, the threats and the route");
  const Hillshade ground = draw_ground(svg, map, site, kPictureColumns);
  draw_threats(svg, map, site);
  draw_points(svg, map, site);
  const bool barred = draw_direct_line(svg, map, site);
  draw_route(svg, map, route);
  draw_used_points(svg, map, site, route);
  if (!route.empty()) draw_violations(svg, map, result.verdict);
  draw_ends(svg, map, site.mission);
  draw_threat_names(svg, map, site);
  draw_scale_and_north(svg, map, result);
  const Shown shown{.result = result, .map = map, .ground = ground, .barred = barred};
  return fmt::format("{}<figure>\n{}{}</figure>\n", caption(shown), svg.str(), legend(shown));
}

}  // namespace alate
