#include "out/json_parts.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "out/route_points.hpp"

namespace alate {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(); }

namespace {

Json plane_json(const std::optional<ArcPlane>& plane) {
  if (!plane) return nullptr;
  return {{"center_z_m", number(plane->center_z_m)},
          {"normal_x", number(plane->normal.x())},
          {"normal_y", number(plane->normal.y())},
          {"normal_z", number(plane->normal.z())}};
}

Json arc_json(const std::optional<Arc>& arc) {
  if (!arc) return nullptr;
  return {{"center_x_m", number(arc->center.x())},
          {"center_y_m", number(arc->center.y())},
          {"radius_m", number(arc->radius_m)},
          {"angle_deg", number(degrees(arc->angle_rad))},
          {"plane", plane_json(arc->plane)}};
}

Json action_json(const std::optional<AttitudeAction>& action) {
  if (!action) return nullptr;
  return {{"roll_deg", number(degrees(action->roll_rad))},
          {"pitch_deg", number(degrees(action->pitch_rad))},
          {"yaw_deg", number(degrees(action->yaw_rad))}};
}

}  // namespace

Json route_json(const Site& site, const Route& route) {
  Json states = Json::array();
  for (const RoutePoint& point : route_points(site, route)) {
    const Vec3& p = point.state.position;
    states.push_back({{"x_m", number(p.x())},
                      {"y_m", number(p.y())},
                      {"z_m", number(p.z())},
                      {"lat", point.geo ? number(point.geo->lat_deg) : Json()},
                      {"lon", point.geo ? number(point.geo->lon_deg) : Json()},
                      {"agl_m", number(point.agl_m)},
                      {"leg", to_string(point.state.leg)},
                      {"arc", arc_json(point.state.arc)},
                      {"point_id", point.state.point_id ? Json(*point.state.point_id) : Json()},
                      {"actions", action_json(point.state.action)}});
  }
  return states;
}

}  // namespace alate
