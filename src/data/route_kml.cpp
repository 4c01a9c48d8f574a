#include <fmt/core.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <string_view>

#include "data/gdal_setup.hpp"
#include "data/limits.hpp"
#include "data/route_formats.hpp"

namespace alate {

namespace {

constexpr std::array<const char*, 3> kDrivers{"LIBKML", "KML", nullptr};

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    RegisterOGRLIBKML();
    RegisterOGRKML();
  });
}

/// Deepest nesting of elements. KML readers recurse, so depth must be limited before one sees the text.
std::size_t element_depth(std::string_view text) {
  std::size_t depth = 0;
  std::size_t deepest = 0;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at + 1)) {
    const char next = at + 1 < text.size() ? text[at + 1] : ' ';
    if (next == '!' || next == '?') continue;
    const std::size_t end = text.find('>', at);
    const bool empty = end != std::string_view::npos && text[end - 1] == '/';
    if (next == '/') {
      depth -= depth > 0 ? 1 : 0;
    } else if (!empty) {
      deepest = std::max(deepest, ++depth);
    }
  }
  return deepest;
}

struct Line {
  std::vector<GivenPlace> places;
  std::string altitude_mode;
};

Line line_of(const OGRLineString& geometry, const std::string& altitude_mode) {
  Line line{.places = {}, .altitude_mode = altitude_mode};
  for (const OGRPoint& point : geometry) {
    GivenPlace place{.lat_deg = point.getY(), .lon_deg = point.getX()};
    if (geometry.Is3D() != 0) place.amsl_m = point.getZ();
    line.places.push_back(place);
  }
  return line;
}

/// All lines, those inside groups of geometries included.
void collect(const OGRGeometry* geometry, const std::string& altitude_mode, std::vector<Line>& lines) {
  if (geometry == nullptr) return;
  const auto kind = wkbFlatten(geometry->getGeometryType());
  if (kind == wkbLineString) lines.push_back(line_of(*geometry->toLineString(), altitude_mode));
  if (kind != wkbMultiLineString && kind != wkbGeometryCollection) return;
  for (const OGRGeometry* part : *geometry->toGeometryCollection()) collect(part, altitude_mode, lines);
}

std::vector<Line> lines_of(GDALDataset& dataset) {
  std::vector<Line> lines;
  for (OGRLayer* layer : dataset.GetLayers()) {
    for (const auto& feature : *layer) {
      const int mode = feature->GetFieldIndex("altitudeMode");
      const bool given = mode >= 0 && feature->IsFieldSetAndNotNull(mode);
      collect(feature->GetGeometryRef(), given ? feature->GetFieldAsString(mode) : "clampToGround", lines);
    }
  }
  return lines;
}

}  // namespace

void read_kml(const std::string& text, RouteBuilder& builder) {
  if (const std::size_t depth = element_depth(text); depth > kMaxNesting) {
    builder.refuse({.value = fmt::format("{}", depth),
                    .limit = fmt::format("<= {}", kMaxNesting),
                    .message = "elements nested too deeply"});
    return;
  }
  register_drivers();
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(builder.file().c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, kDrivers.data()));
  if (!dataset) {
    builder.refuse({.message = "not valid KML"});
    return;
  }
  const std::vector<Line> lines = lines_of(*dataset);
  if (lines.size() != 1) {
    builder.refuse({.value = fmt::format("{}", lines.size()), .limit = "1", .message = "a route is one LineString"});
    return;
  }
  const Line& line = lines.front();
  if (line.altitude_mode != "absolute") {
    builder.refuse({.field = "altitudeMode",
                    .value = line.altitude_mode,
                    .limit = "absolute",
                    .message = "heights must be above mean sea level"});
    return;
  }
  for (std::size_t i = 0; i < line.places.size(); ++i) {
    builder.add(line.places[i], {}, {.field = fmt::format("coordinates.{}", i)});
  }
}

}  // namespace alate
