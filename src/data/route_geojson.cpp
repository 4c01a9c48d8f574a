#include <fmt/core.h>

#include "data/route_formats.hpp"

namespace alate {

namespace {

struct Line {
  const Json* coordinates;
  std::string field;
};

void collect_geometry(const Json& geometry, const std::string& field, std::vector<Line>& lines) {
  if (member(geometry, "type") == "LineString") {
    lines.push_back({&member(geometry, "coordinates"), field + "coordinates"});
  }
}

std::vector<Line> lines_of(const Json& document) {
  std::vector<Line> lines;
  collect_geometry(document, "", lines);
  if (member(document, "type") == "Feature") collect_geometry(member(document, "geometry"), "geometry.", lines);
  const Json& features = member(document, "features");
  for (std::size_t i = 0; features.is_array() && i < features.size(); ++i) {
    collect_geometry(member(features[i], "geometry"), fmt::format("features.{}.geometry.", i), lines);
  }
  return lines;
}

void add_position(const Json& position, const std::string& field, RouteBuilder& builder) {
  if (!position.is_array() || position.size() < 2) {
    builder.refuse({.field = field, .value = shown(position), .message = "must be [lon, lat, height]"});
    return;
  }
  const auto part = [&](std::size_t i) {
    return i < position.size() ? number_in(position[i], fmt::format("{}.{}", field, i), builder) : std::nullopt;
  };
  builder.add({.lat_deg = part(1), .lon_deg = part(0), .amsl_m = part(2)}, {}, {.field = field});
}

}  // namespace

void read_geojson(const Json& document, RouteBuilder& builder) {
  const std::vector<Line> lines = lines_of(document);
  if (lines.size() != 1) {
    builder.refuse({.value = fmt::format("{}", lines.size()), .limit = "1", .message = "a route is one LineString"});
    return;
  }
  const auto& [coordinates, field] = lines.front();
  if (!coordinates->is_array()) {
    builder.refuse({.field = field, .value = shown(*coordinates), .message = "must be a list of positions"});
    return;
  }
  for (std::size_t i = 0; i < coordinates->size(); ++i) {
    add_position((*coordinates)[i], fmt::format("{}.{}", field, i), builder);
  }
}

}  // namespace alate
