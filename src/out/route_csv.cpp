#include <fmt/core.h>

#include <iterator>

#include "out/route_files.hpp"
#include "out/text.hpp"

namespace alate {

std::string route_csv(const RouteToWrite& route) {
  std::string csv = "leg,kind,x_m,y_m,z_m,lat,lon,amsl_m,agl_m,heading_deg,point_id\n";
  std::size_t leg = 0;
  for (const RoutePoint& point : route.points) {
    const Vec3& p = point.state.position;
    const auto lat = point.geo ? std::optional(point.geo->lat_deg) : std::nullopt;
    const auto lon = point.geo ? std::optional(point.geo->lon_deg) : std::nullopt;
    const std::string id = point.state.point_id ? fmt::format("{}", *point.state.point_id) : "";
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{}\n", leg++, to_string(point.state.leg),
                   round_trip(p.x()), round_trip(p.y()), round_trip(p.z()), round_trip(lat), round_trip(lon),
                   round_trip(p.z()), round_trip(point.agl_m), round_trip(degrees(point.heading_rad)), id);
  }
  return csv;
}

}  // namespace alate
