#include "out/report/routes_map.hpp"

#include "out/report/map_layers.hpp"
#include "out/route_points.hpp"

namespace alate {

namespace {

constexpr int kColumns = 320;  ///< Of the picture of the ground.

void draw_faintly(Svg& svg, const MapFrame& map, const Route& route) {
  std::vector<Vec2> line;
  for (const Vec3& at : drawn_line(route)) line.push_back(map(at));
  if (line.size() > 1) svg.polyline(line, "route faint");
}

}  // namespace

std::string routes_map(const Site& site, const MapFrame& map, const std::vector<MapRoute>& routes,
                       const std::string& title) {
  Svg svg(map.width, map.height(), title);
  draw_ground(svg, map, site, kColumns);
  draw_threats(svg, map, site);
  for (const MapRoute& each : routes)
    if (each.faint) draw_faintly(svg, map, *each.route);
  for (const MapRoute& each : routes)
    if (!each.faint) draw_route(svg, map, *each.route);
  for (const MapRoute& each : routes)
    if (each.verdict != nullptr) draw_violations(svg, map, *each.verdict);
  draw_ends(svg, map, site.mission);
  return svg.str();
}

}  // namespace alate
