// Reads members of parsed JSON and reports those of the wrong kind.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "data/route_builder.hpp"

namespace alate {

using Json = nlohmann::json;

/// Parses text that may hold // comments. Throws InputError with line and column.
Json parse_route_json(const std::string& text, const std::string& file);

/// Member `key`, or null if it is absent or `value` is no object.
const Json& member(const Json& value, const std::string& key);

/// The value as a number; nothing for null, and a fault for any other kind.
std::optional<double> number_in(const Json& value, const std::string& field, RouteBuilder& builder);

/// The value as a whole number; nothing for null, and a fault for any other kind.
std::optional<int> integer_in(const Json& value, const std::string& field, RouteBuilder& builder);

/// Short text of a value, for faults.
std::string shown(const Json& value);

}  // namespace alate
