#include <nlohmann/json.hpp>

#include "alate/core/version.hpp"
#include "out/notes.hpp"
#include "out/route_files.hpp"

namespace alate {

namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const GeoPoint& geo, double height_m) { return Json::array({geo.lon_deg, geo.lat_deg, height_m}); }

Json feature(const char* type, Json geometry, Json properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move(geometry)}}},
          {"properties", std::move(properties)}};
}

/// A point feature, left out where the frame cannot be undone.
void add_point(Json& features, const Site& site, const Vec3& at, Json properties) {
  if (const auto geo = site.frame.to_geo(at.head<2>()))
    features.push_back(feature("Point", coordinates(*geo, at.z()), std::move(properties)));
}

Json line_of(const Result& result) {
  Json line = Json::array();
  for (const Vec3& at : drawn_line(result.plan.route)) {
    if (const auto geo = result.site.frame.to_geo(at.head<2>())) line.push_back(coordinates(*geo, at.z()));
  }
  return line;
}

}  // namespace

std::string route_geojson(const RouteToWrite& route) {
  const Result& result = route.result;
  const Site& site = result.site;
  Json features = Json::array();
  // A LineString has two positions at least.
  if (route.points.size() > 1) {
    features.push_back(feature("LineString", line_of(result),
                               {{"role", "route"},
                                {"length_m", result.metrics.length_m},
                                {"cost", result.metrics.cost},
                                {"verdict", to_string(result.verdict.status)}}));
  }
  add_point(features, site, site.mission.start, {{"role", "start"}});
  add_point(features, site, site.mission.goal, {{"role", "goal"}, {"tolerance_m", site.mission.tolerance_m}});
  for (const Threat& threat : site.threats) {
    add_point(features, site, threat.center,
              {{"role", "threat"},
               {"name", threat.name},
               {"radius_m", threat.radius_m},
               {"core_m", threat.core_m},
               {"level", threat.level}});
  }
  const Json collection{{"type", "FeatureCollection"},      {"alate", version()},
                        {"datum", ground_note(site).datum}, {"heights", "metres above mean sea level"},
                        {"notice", notice(site)},           {"features", features}};
  return collection.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace alate
