// Makes the fields of a description from members of a struct.
#pragma once

#include <algorithm>

#include "data/scenario_fields.hpp"

namespace alate {

constexpr Range above(double min) { return {.min = min, .max = kMaxMagnitude, .open = true}; }
constexpr Range at_least(double min) { return {.min = min, .max = kMaxMagnitude}; }
constexpr Range from_to(double min, double max) { return {.min = min, .max = max}; }
constexpr Range between(double min, double max) { return {.min = min, .max = max, .open = true}; }

/// A double or an optional one.
template <class Value>
Number number(Value& value, Range range = {}) {
  return {.value = value, .set = [&value](double given) { value = given; }, .range = range};
}

/// An int or an optional one.
template <class Value>
Number whole(Value& value, Range range) {
  return {.value = value,
          .set = [&value](double given) { value = static_cast<int>(given); },
          .range = range,
          .whole = true};
}

template <std::size_t N>
Numbers numbers(std::array<double, N>& value, Range range = {}) {
  return {.value = {value.begin(), value.end()},
          .set = [&value](const std::vector<double>& given) { std::ranges::copy(given, value.begin()); },
          .range = range,
          .count = N};
}

template <std::size_t N>
Numbers numbers(std::optional<std::array<double, N>>& value, Range range = {}) {
  std::vector<double> present;
  if (value) present.assign(value->begin(), value->end());
  return {.value = std::move(present),
          .set = [&value](const std::vector<double>& given) { std::ranges::copy(given, value.emplace().begin()); },
          .range = range,
          .count = N};
}

inline std::array<int, 2> whole_pair(const std::vector<double>& given) {
  return {static_cast<int>(given[0]), static_cast<int>(given[1])};
}

inline Numbers whole_numbers(std::array<int, 2>& value, Range range) {
  return {.value = {value.begin(), value.end()},
          .set = [&value](const std::vector<double>& given) { value = whole_pair(given); },
          .range = range,
          .count = 2,
          .whole = true};
}

/// Two numbers, or three with `third`.
inline Numbers whole_numbers(std::optional<std::array<int, 2>>& value, std::optional<int>& third, Range range) {
  std::vector<double> present;
  if (value) present.assign(value->begin(), value->end());
  if (third) present.push_back(*third);
  return {.value = std::move(present),
          .set =
              [&value, &third](const std::vector<double>& given) {
                value = whole_pair(given);
                if (given.size() > 2) third = static_cast<int>(given[2]);
              },
          .range = range,
          .count = 2,
          .whole = true,
          .one_more = true};
}

inline Numbers numbers(std::vector<double>& value, Range range) {
  return {.value = value, .set = [&value](const std::vector<double>& given) { value = given; }, .range = range};
}

inline Text text(std::string& value, Text::Use use = Text::Use::word) {
  return {.value = value.empty() ? std::nullopt : std::optional(value),
          .set = [&value](std::string given) { value = std::move(given); },
          .use = use};
}

inline Flag flag(bool& value) {
  return {.value = value, .set = [&value](bool given) { value = given; }};
}

/// `words` in the order of the enumerators.
template <class Enum>
Choice choice(Enum& value, std::initializer_list<std::string> words) {
  return {.words = words, .value = static_cast<std::size_t>(value), .set = [&value](std::size_t given) {
            value = static_cast<Enum>(given);
          }};
}

inline Field field(std::string key, std::string unit, std::string help, Slot slot) {
  return {.key = std::move(key), .unit = std::move(unit), .help = std::move(help), .slot = std::move(slot)};
}

inline Field required(Field field) {
  field.required = true;
  return field;
}

inline Field required_unless(std::string key, Field field) {
  field.unless = std::move(key);
  return required(std::move(field));
}

inline Field written_if(bool condition, Field field) {
  field.written = condition;
  return field;
}

}  // namespace alate
