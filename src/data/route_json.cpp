#include "data/route_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/scenario_text.hpp"

namespace alate {

namespace {

/// Fault at the byte where the parser stopped (1-based).
Fault fault_at(const std::string& text, const std::string& file, std::size_t byte) {
  const std::size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto begin = text.begin();
  const auto stop = begin + static_cast<std::ptrdiff_t>(end);
  const std::size_t newline = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t line_start = newline == std::string::npos ? 0 : newline + 1;
  return {.file = file,
          .line = 1 + static_cast<int>(std::count(begin, stop, '\n')),
          .column = 1 + static_cast<int>(end - line_start),
          .message = "not valid JSON here: cut off or mistyped"};
}

}  // namespace

Json parse_route_json(const std::string& text, const std::string& file) {
  constexpr bool kThrow = true;
  constexpr bool kComments = true;
  try {
    return Json::parse(text, nullptr, kThrow, kComments);
  } catch (const Json::parse_error& error) {
    throw InputError(fault_at(text, file, error.byte));
  } catch (const Json::exception&) {
    throw InputError(Fault{.file = file, .message = "holds a number too large to be read"});
  }
}

const Json& member(const Json& value, const std::string& key) {
  static const Json kNull;
  if (!value.is_object()) return kNull;
  const auto found = value.find(key);
  return found == value.end() ? kNull : *found;
}

std::optional<double> number_in(const Json& value, const std::string& field, RouteBuilder& builder) {
  if (value.is_null()) return std::nullopt;
  if (value.is_number()) return value.get<double>();
  builder.refuse({.field = field, .value = shown(value), .message = "must be a number"});
  return std::nullopt;
}

std::optional<int> integer_in(const Json& value, const std::string& field, RouteBuilder& builder) {
  const auto number = number_in(value, field, builder);
  if (!number) return std::nullopt;
  if (std::abs(*number) <= std::numeric_limits<int>::max() && std::trunc(*number) == *number) {
    return static_cast<int>(*number);
  }
  builder.refuse({.field = field, .value = shown(value), .message = "must be a whole number"});
  return std::nullopt;
}

std::string shown(const Json& value) {
  if (value.is_array()) return "a list";
  if (value.is_object()) return "a group";
  return shortened(value.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace alate
