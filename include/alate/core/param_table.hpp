// Parameters of planners, described once: command line, schema, docs and other languages read this table.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "alate/core/fault.hpp"

namespace alate {

using ParamValue = std::variant<bool, std::int64_t, double, std::string>;

/// The value as a user would write it.
std::string to_text(const ParamValue& value);

/// One parameter. The type of `default_value` is the type of the parameter.
struct Parameter {
  std::string name;
  std::string unit;  ///< Empty for a pure number.
  ParamValue default_value;
  double min = 0;  ///< Numbers only; both ends allowed.
  double max = 0;
  bool above_min = false;            ///< `min` itself is not allowed.
  std::vector<std::string> choices;  ///< Text only.
  std::string help;
  std::string source;  ///< Paper and equation, or "alate".

  /// "0 to 1", "> 0, <= 1", "J | J+h", "true | false".
  std::string range() const;
};

/// Values of all parameters of one planner, complete and within range. Asking for an unknown name or the
/// wrong type is a programmer's mistake.
class ParamValues {
 public:
  explicit ParamValues(std::map<std::string, ParamValue, std::less<>> values) : values_(std::move(values)) {}

  bool flag(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double number(std::string_view name) const;
  const std::string& text(std::string_view name) const;
  const std::map<std::string, ParamValue, std::less<>>& all() const { return values_; }

 private:
  const ParamValue& at(std::string_view name) const;
  std::map<std::string, ParamValue, std::less<>> values_;
};

/// What a user wrote for one parameter, and where.
struct ParamSetting {
  std::string name;
  std::string text;
  std::string file;  ///< Scenario file, or "--set".
  int line = 0;
  int column = 0;
};

class ParamTable {
 public:
  ParamTable() = default;
  explicit ParamTable(std::vector<Parameter> parameters) : parameters_(std::move(parameters)) {}

  const std::vector<Parameter>& parameters() const { return parameters_; }
  const Parameter* find(std::string_view name) const;

  /// Defaults, then `preset`, then `settings` in order (later wins). Every unknown name, wrong type and value
  /// out of range is added to `faults`; the values returned are always complete.
  ParamValues resolve(const std::map<std::string, ParamValue>& preset, const std::vector<ParamSetting>& settings,
                      std::vector<Fault>& faults) const;

 private:
  std::vector<Parameter> parameters_;
};

/// The candidate nearest to `word`, or empty if none is near (for "did you mean"): one that differs by its unit only
/// (`radius` and `radius_m`), else the least edit distance, up to 3 and half of the shorter word.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `at` as the fault of naming a `kind` ("planner", "parameter") that does not exist: the nearest one is named.
Fault unknown_name(Fault at, std::string_view kind, const std::string& name, const std::vector<std::string>& known);

}  // namespace alate
