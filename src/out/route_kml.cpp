#include <fmt/core.h>

#include <cmath>
#include <iterator>

#include "out/notes.hpp"
#include "out/route_files.hpp"
#include "out/text.hpp"

namespace alate {

namespace {

/// Colours are aabbggrr.
constexpr std::string_view kHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2">
<Document>
<Style id="route"><LineStyle><color>ff00d7ff</color><width>4</width></LineStyle><PolyStyle><color>5000d7ff</color></PolyStyle></Style>
<Style id="threat"><LineStyle><color>ff3c14dc</color></LineStyle><PolyStyle><color>403c14dc</color></PolyStyle></Style>
<Style id="core"><LineStyle><color>ff3c14dc</color></LineStyle><PolyStyle><color>b03c14dc</color></PolyStyle></Style>
)";

/// "lon,lat,height", nothing where the frame cannot be undone. Eight decimals are a millimetre.
std::string tuple(const Site& site, const Vec3& at) {
  const auto geo = site.frame.to_geo(at.head<2>());
  return geo ? fmt::format("{:.8f},{:.8f},{:.3f} ", geo->lon_deg, geo->lat_deg, at.z()) : "";
}

std::string placemark(std::string_view name, std::string_view style, std::string_view geometry) {
  return fmt::format("<Placemark><name>{}</name><styleUrl>#{}</styleUrl>\n{}\n</Placemark>\n", xml_escape(name), style,
                     geometry);
}

std::string point(const Site& site, const Vec3& at) {
  return fmt::format("<Point><altitudeMode>absolute</altitudeMode><coordinates>{}</coordinates></Point>",
                     tuple(site, at));
}

std::string route_line(const Result& result) {
  std::string text;
  for (const Vec3& at : drawn_line(result.plan.route)) text += tuple(result.site, at);
  return fmt::format(
      "<LineString><extrude>1</extrude><altitudeMode>absolute</altitudeMode><coordinates>{}</coordinates></LineString>",
      text);
}

/// A circle at the height of a sphere's centre; a cylinder stands from its top down to the ground.
std::string circle(const Site& site, const Threat& threat, double radius_m) {
  constexpr int kCorners = 48;
  const bool cylinder = threat.shape == Threat::Shape::cylinder;
  std::string ring;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = -2 * kPi * (i % kCorners) / kCorners;  // anticlockwise from north, as KML asks
    Vec3 at = threat.center + radius_m * direction_of(angle);
    if (cylinder) at.z() = threat.top_m;
    ring += tuple(site, at);
  }
  return fmt::format(
      "<Polygon><extrude>{}</extrude><altitudeMode>absolute</altitudeMode><outerBoundaryIs><LinearRing><coordinates>{}"
      "</coordinates></LinearRing></outerBoundaryIs></Polygon>",
      cylinder ? 1 : 0, ring);
}

}  // namespace

std::string route_kml(const RouteToWrite& route) {
  const Result& result = route.result;
  const Site& site = result.site;
  std::string kml(kHead);
  kml += fmt::format("<name>alate: {}</name>\n<description>{}</description>\n", xml_escape(site.scenario.file),
                     xml_escape(summary(result) + "\n" + notice(site)));
  if (route.points.size() > 1) kml += placemark("Route", "route", route_line(result));
  kml += placemark("Start", "route", point(site, site.mission.start));
  kml += placemark("Goal", "route", point(site, site.mission.goal));
  for (const Threat& threat : site.threats) {
    kml += placemark(threat.name, "threat", circle(site, threat, threat.radius_m));
    if (threat.core_m > 0) kml += placemark(threat.name + " core", "core", circle(site, threat, threat.core_m));
  }
  return kml + "</Document>\n</kml>\n";
}

}  // namespace alate
