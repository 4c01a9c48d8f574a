#include "alate/core/param_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

namespace alate {

namespace {

template <class Number>
std::optional<Number> parse_number(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

/// Reads `text` as a value of the parameter's type; nothing if it is not one.
std::optional<ParamValue> parse(const Parameter& parameter, const std::string& text) {
  if (std::holds_alternative<bool>(parameter.default_value)) {
    if (text == "true") return true;
    if (text == "false") return false;
    return std::nullopt;
  }
  if (std::holds_alternative<std::int64_t>(parameter.default_value)) return parse_number<std::int64_t>(text);
  if (std::holds_alternative<double>(parameter.default_value)) return parse_number<double>(text);
  return text;
}

bool in_range(const Parameter& parameter, const ParamValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number >= parameter.min && *number <= parameter.max;
  if (const auto* count = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*count) >= parameter.min && static_cast<double>(*count) <= parameter.max;
  if (const auto* word = std::get_if<std::string>(&value))
    return std::ranges::find(parameter.choices, *word) != parameter.choices.end();
  return true;
}

const char* type_name(const ParamValue& value) {
  static constexpr std::array<const char*, 4> kNames{"true or false", "a whole number", "a number", "a word"};
  return kNames[value.index()];
}

Fault fault_at(const ParamSetting& setting, std::string message) {
  return {.file = setting.file,
          .line = setting.line,
          .column = setting.column,
          .field = setting.name,
          .value = setting.text,
          .message = std::move(message)};
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

std::string to_text(const ParamValue& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

std::string Parameter::range() const {
  if (std::holds_alternative<bool>(default_value)) return "true | false";
  if (std::holds_alternative<std::string>(default_value)) return fmt::format("{}", fmt::join(choices, " | "));
  return fmt::format("{} to {}", min, max);
}

const ParamValue& ParamValues::at(std::string_view name) const {
  const auto found = values_.find(name);
  assert(found != values_.end());
  return found->second;
}

bool ParamValues::flag(std::string_view name) const { return std::get<bool>(at(name)); }
std::int64_t ParamValues::integer(std::string_view name) const { return std::get<std::int64_t>(at(name)); }
double ParamValues::number(std::string_view name) const { return std::get<double>(at(name)); }
const std::string& ParamValues::text(std::string_view name) const { return std::get<std::string>(at(name)); }

const Parameter* ParamTable::find(std::string_view name) const {
  const auto found = std::ranges::find(parameters_, name, &Parameter::name);
  return found == parameters_.end() ? nullptr : &*found;
}

ParamValues ParamTable::resolve(const std::map<std::string, ParamValue>& preset,
                                const std::vector<ParamSetting>& settings, std::vector<Fault>& faults) const {
  std::map<std::string, ParamValue, std::less<>> values;
  for (const Parameter& parameter : parameters_) values[parameter.name] = parameter.default_value;
  for (const auto& [name, value] : preset) {
    assert(find(name) != nullptr && in_range(*find(name), value));
    values[name] = value;
  }
  for (const ParamSetting& setting : settings) {
    const Parameter* parameter = find(setting.name);
    if (parameter == nullptr) {
      std::vector<std::string> names;
      names.reserve(parameters_.size());
      for (const Parameter& known : parameters_) names.push_back(known.name);
      const std::string near = nearest(setting.name, names);
      faults.push_back(fault_at(setting, "unknown parameter" + (near.empty() ? "" : "; did you mean " + near + "?")));
      continue;
    }
    const auto value = parse(*parameter, setting.text);
    if (value && in_range(*parameter, *value)) {
      values[setting.name] = *value;
      continue;
    }
    Fault fault =
        fault_at(setting, value ? "out of range" : fmt::format("is not {}", type_name(parameter->default_value)));
    fault.limit = parameter->range();
    fault.unit = parameter->unit;
    faults.push_back(std::move(fault));
  }
  return ParamValues(std::move(values));
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace alate
