#include "alate/core/param_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <numeric>
#include <optional>
#include <utility>

#include "core/number_text.hpp"

namespace alate {

namespace {

/// What a user wrote for a parameter: its value, or why it has none.
struct Reading {
  std::optional<ParamValue> value;
  std::string problem;
};

Reading read_integer(const std::string& text) {
  const NumberText number = parse_number(text);
  if (!number.problem.empty()) return {.problem = number.problem};
  std::int64_t value = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stopped != end) return {.problem = "must be a whole number"};
  return {.value = value};
}

/// Reads `text` as a value of the parameter's type.
Reading read(const Parameter& parameter, const std::string& text) {
  if (std::holds_alternative<bool>(parameter.default_value)) {
    if (text == "true" || text == "false") return {.value = text == "true"};
    return {.problem = "must be true or false"};
  }
  if (std::holds_alternative<std::int64_t>(parameter.default_value)) return read_integer(text);
  if (std::holds_alternative<double>(parameter.default_value)) {
    NumberText number = parse_number(text);
    if (number.problem.empty()) return {.value = number.value};
    return {.problem = std::move(number.problem)};
  }
  return {.value = text};
}

bool in_range(const Parameter& parameter, const ParamValue& value) {
  if (const auto* number = std::get_if<double>(&value))
    return (parameter.above_min ? *number > parameter.min : *number >= parameter.min) && *number <= parameter.max;
  if (const auto* count = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*count) >= parameter.min && static_cast<double>(*count) <= parameter.max;
  if (const auto* word = std::get_if<std::string>(&value))
    return std::ranges::find(parameter.choices, *word) != parameter.choices.end();
  return true;
}

Fault fault_at(const ParamSetting& setting, std::string message) {
  return {.file = setting.file,
          .line = setting.line,
          .column = setting.column,
          .field = setting.name,
          .value = setting.text,
          .message = std::move(message)};
}

Fault unknown(const ParamSetting& setting, const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  names.reserve(parameters.size());
  for (const Parameter& known : parameters) names.push_back(known.name);
  return unknown_name(fault_at(setting, ""), "parameter", setting.name, names);
}

Fault refused(const ParamSetting& setting, const Parameter& parameter, const Reading& reading) {
  Fault fault = fault_at(setting, reading.value ? "out of range" : reading.problem);
  fault.limit = parameter.range();
  fault.unit = parameter.unit;
  return fault;
}

/// Do the words differ only by what follows an underscore, as `radius` and `radius_m`?
bool differ_by_unit(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return !a.empty() && b.starts_with(a) && b.substr(a.size()).starts_with('_');
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
  if (above_min) return fmt::format("> {}, <= {}", min, max);
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
      faults.push_back(unknown(setting, parameters_));
      continue;
    }
    Reading reading = read(*parameter, setting.text);
    if (reading.value && in_range(*parameter, *reading.value)) {
      values[setting.name] = *std::move(reading.value);
    } else {
      faults.push_back(refused(setting, *parameter, reading));
    }
  }
  return ParamValues(std::move(values));
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kMostEdits = 3;
  std::string best;
  std::size_t best_distance = kMostEdits + 1;
  for (const std::string& candidate : candidates) {
    if (differ_by_unit(word, candidate)) return candidate;
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    if (longer - shorter > kMostEdits) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance && 2 * distance <= shorter) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

Fault unknown_name(Fault at, std::string_view kind, const std::string& name, const std::vector<std::string>& known) {
  const std::string near = nearest(name, known);
  at.value = name;
  at.limit = fmt::format("{}", fmt::join(known, " | "));
  at.message = fmt::format("unknown {}{}", kind, near.empty() ? "" : fmt::format("; did you mean {}?", near));
  return at;
}

}  // namespace alate
