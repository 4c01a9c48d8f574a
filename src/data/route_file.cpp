#include "alate/data/route_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "data/limits.hpp"
#include "data/route_formats.hpp"
#include "data/text_file.hpp"

namespace alate {

namespace {

std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// The format of a text by its first words; "json" for any JSON. Empty: the extension must tell.
std::string format_by_content(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("QGC WPL")) return "waypoints";
  if (text.starts_with('{') || text.starts_with("//")) return "json";
  if (text.starts_with('<')) return "kml";
  const std::string_view header = text.substr(0, std::min(text.find('\n'), text.size()));
  const bool places = header.find("x_m,") != std::string_view::npos || header.find("lat,") != std::string_view::npos;
  return places ? "csv" : "";
}

std::string format_by_extension(const std::string& extension) {
  if (extension == ".csv") return "csv";
  if (extension == ".waypoints" || extension == ".txt") return "waypoints";
  if (extension == ".plan" || extension == ".json" || extension == ".geojson") return "json";
  return "";
}

/// Which of the JSON formats; an unknown one is taken for what the extension says, at last for a result.
std::string json_format(const Json& document, const std::string& extension) {
  const auto has = [&](const char* key) { return !member(document, key).is_null(); };
  if (has("fileType") || has("mission")) return "plan";
  if (has("features") || has("geometry") || has("coordinates")) return "geojson";
  if (has("route") || has("schema")) return "result";
  if (extension == ".plan") return "plan";
  return extension == ".geojson" ? "geojson" : "result";
}

struct Opened {
  std::string text;
  std::string format;
  Json json;  ///< Only JSON formats.
};

Opened open(const std::string& file) {
  Opened opened{.text = read_text_file(file, kMaxRouteBytes), .format = {}, .json = {}};
  if (opened.text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(Fault{.file = file, .message = "the file is empty"});
  }
  opened.format = format_by_content(opened.text);
  if (opened.text.find('\0') != std::string::npos) opened.format = "binary";
  if (opened.format.empty()) opened.format = format_by_extension(extension_of(file));
  if (opened.format == "json") {
    opened.json = parse_route_json(opened.text, file);
    opened.format = json_format(opened.json, extension_of(file));
  }
  return opened;
}

void read(const Opened& opened, RouteBuilder& builder) {
  if (opened.format == "result") return read_result(opened.json, builder);
  if (opened.format == "plan") return read_plan(opened.json, builder);
  if (opened.format == "geojson") return read_geojson(opened.json, builder);
  if (opened.format == "waypoints") return read_waypoints(opened.text, builder);
  if (opened.format == "csv") return read_csv(opened.text, builder);
  if (opened.format == "kml") return read_kml(opened.text, builder);
  builder.refuse({.limit = "result.json, route.csv, .plan, .waypoints, .kml or .geojson",
                  .message = "not a route in a format that alate reads"});
}

}  // namespace

RouteFile load_route(const std::string& file, const Frame& frame) {
  const Opened opened = open(file);
  RouteBuilder builder(frame, file, opened.format);
  read(opened, builder);
  return builder.finish();
}

RouteFile peek_result(const std::string& file) {
  const Opened opened = open(file);
  RouteBuilder builder(Frame::local(), file, opened.format);
  if (opened.format == "result") read_result_origin(opened.json, builder);
  return builder.finish_origin();
}

}  // namespace alate
