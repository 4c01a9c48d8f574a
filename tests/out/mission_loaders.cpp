#include "mission_loaders.hpp"

#include <charconv>
#include <sstream>
#include <vector>

namespace alate::test {

namespace {

using Json = nlohmann::json;

enum class Type { text, number, truth, list, group };

bool is_a(const Json& value, Type type) {
  switch (type) {
    case Type::text:
      return value.is_string();
    case Type::number:
      return value.is_number() || value.is_null();  // null stands for NaN
    case Type::truth:
      return value.is_boolean();
    case Type::list:
      return value.is_array();
    case Type::group:
      break;
  }
  return value.is_object();
}

struct Key {
  const char* name;
  Type type;
  bool required = true;
};

/// JsonHelper::validateKeys.
std::string wrong_key(const Json& object, const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    if (!object.contains(key.name)) {
      if (key.required) return std::string("missing ") + key.name;
    } else if (!is_a(object[key.name], key.type)) {
      return std::string("wrong type of ") + key.name;
    }
  }
  return {};
}

/// JsonHelper::loadGeoCoordinate with a required altitude.
std::string wrong_coordinate(const Json& value) {
  if (!value.is_array() || value.size() != 3) return "a coordinate has three values";
  for (const Json& number : value) {
    if (!is_a(number, Type::number)) return "a coordinate holds numbers";
  }
  return {};
}

bool has_altitude_keys(const Json& item) {
  return item.contains("AltitudeMode") || item.contains("Altitude") || item.contains("AMSLAltAboveTerrain");
}

std::string wrong_simple_item(const Json& item) {
  std::string fault = wrong_key(item, {{"type", Type::text},
                                       {"frame", Type::number},
                                       {"command", Type::number},
                                       {"params", Type::list},
                                       {"autoContinue", Type::truth},
                                       {"doJumpId", Type::number, false}});
  if (!fault.empty()) return fault;
  if (item["params"].size() != 7) return "params must have 7 values";
  for (const Json& param : item["params"]) {
    if (!is_a(param, Type::number)) return "a param is a number or null";
  }
  if (!has_altitude_keys(item)) return {};
  return wrong_key(item,
                   {{"AltitudeMode", Type::number}, {"Altitude", Type::number}, {"AMSLAltAboveTerrain", Type::number}});
}

std::string wrong_mission(const Json& mission) {
  std::string fault = wrong_key(mission, {{"plannedHomePosition", Type::list},
                                          {"items", Type::list},
                                          {"firmwareType", Type::number},
                                          {"vehicleType", Type::number, false},
                                          {"cruiseSpeed", Type::number, false},
                                          {"hoverSpeed", Type::number, false},
                                          {"globalPlanAltitudeMode", Type::number, false},
                                          {"version", Type::number}});
  if (!fault.empty()) return fault;
  if (mission["version"] != 2) return "mission version is not 2";
  fault = wrong_coordinate(mission["plannedHomePosition"]);
  for (const Json& item : mission["items"]) {
    if (!fault.empty()) break;
    fault = wrong_key(item, {{"type", Type::text}});
    if (fault.empty() && item["type"] == "SimpleItem") fault = wrong_simple_item(item);
    if (fault.empty() && item["type"] != "SimpleItem" && item["type"] != "ComplexItem") fault = "unknown item type";
  }
  return fault;
}

std::vector<std::string> split_at(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);) cells.push_back(cell);
  return cells;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

template <class Number>
bool is_number(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::string qgroundcontrol_refuses_plan(const std::string& text) {
  const Json plan = Json::parse(text, nullptr, false);
  if (!plan.is_object()) return "not JSON";
  std::string fault = wrong_key(plan, {{"groundStation", Type::text},
                                       {"fileType", Type::text},
                                       {"version", Type::number},
                                       {"mission", Type::group},
                                       {"geoFence", Type::group},
                                       {"rallyPoints", Type::group}});
  if (!fault.empty()) return fault;
  if (plan["fileType"] != "Plan") return "not a plan";
  if (plan["version"] != 1) return "version is not 1";
  fault = wrong_mission(plan["mission"]);
  if (fault.empty()) fault = wrong_key(plan["geoFence"], {{"version", Type::number}});
  if (fault.empty()) fault = wrong_key(plan["rallyPoints"], {{"points", Type::list}, {"version", Type::number}});
  return fault;
}

std::string qgroundcontrol_refuses_waypoints(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  if (line != "QGC WPL 110") return "first line";
  while (std::getline(stream, line)) {
    if (split_at(line, '\t').size() != 12) return "not twelve cells: " + line;
  }
  return {};
}

std::string mavproxy_refuses_waypoints(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  if (words(line) != std::vector<std::string>{"QGC", "WPL", "110"}) return "first line";
  while (std::getline(stream, line)) {
    const auto cells = words(line);
    if (cells.empty() || line.starts_with('#')) continue;
    if (cells.size() != 12) return "not twelve words: " + line;
    for (const std::size_t i : {0U, 1U, 2U, 3U, 11U}) {
      if (!is_number<int>(cells[i])) return "not whole: " + cells[i];
    }
    for (std::size_t i = 4; i < 11; ++i) {
      if (!is_number<double>(cells[i])) return "not a number: " + cells[i];
    }
  }
  return {};
}

}  // namespace alate::test
