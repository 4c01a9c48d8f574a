// The keys of a scenario, told once. Reader, writer, schema, manual and template are loops over this table.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "alate/core/scenario.hpp"
#include "data/limits.hpp"

namespace alate {

/// Allowed numbers. An end at kMaxMagnitude is no limit of the field itself.
struct Range {
  double min = -kMaxMagnitude;
  double max = kMaxMagnitude;
  bool open = false;  ///< Both ends excluded.

  bool holds(double value) const { return open ? value > min && value < max : value >= min && value <= max; }
  /// "> 0", ">= 0", "-90 to 90", "> 0 and < 90"; empty without a limit.
  std::string text() const;
};

struct Description;

// The kinds of fields. `value` is the present value, which in a fresh struct is the default; `set` stores another.
struct Text {
  std::optional<std::string> value;
  std::function<void(std::string)> set;
  enum class Use { word, path, label } use = Use::word;  ///< A label may be empty; a path is relative to its file.
};
struct Flag {
  bool value = false;
  std::function<void(bool)> set;
};
struct Number {
  std::optional<double> value;
  std::function<void(double)> set;
  Range range;
  bool whole = false;
};
struct Numbers {
  std::vector<double> value;
  std::function<void(const std::vector<double>&)> set;
  Range range;
  std::size_t count = 0;  ///< 0: from 1 to kMaxAngles.
  bool whole = false;
  bool one_more = false;  ///< There may be one more than `count`.

  std::size_t least() const { return count > 0 ? count : 1; }
  std::size_t most() const { return count > 0 ? count + (one_more ? 1U : 0U) : kMaxAngles; }
};
struct Choice {
  std::vector<std::string> words;
  std::size_t value = 0;
  std::function<void(std::size_t)> set;
};
struct Group {
  bool present = true;
  std::function<Description()> open;  ///< Makes the group if it is absent.
};
struct Groups {
  std::size_t count = 0;
  std::size_t least = 0;                       ///< Up to kMaxListItems.
  std::function<Description(std::size_t)> at;  ///< Makes items up to this index.
};
/// The name of a file, or what would stand in it as a list.
struct FileOrGroups {
  Text file;
  Groups items;
};
struct Words {
  std::map<std::string, std::string>* values = nullptr;
};

using Slot = std::variant<Text, Flag, Number, Numbers, Choice, Group, Groups, FileOrGroups, Words>;

struct Field {
  std::string key;
  std::string unit;  ///< Empty for pure numbers and all else.
  std::string help;  ///< One plain sentence or more.
  Slot slot;
  bool required = false;
  std::string unless;   ///< Key beside it with which it is not required.
  bool written = true;  ///< False where the value means nothing beside what else is given.
};

/// One group of keys. Pointers into the struct described live as long as it does.
struct Description {
  std::vector<Field> fields;
  /// Sets of keys of which exactly one is to be given, whole; an empty set allows none of them.
  std::vector<std::vector<std::string>> one_of;
};

/// "position_m | lat, lon, amsl_m"; "none" for the empty set.
std::string text_of(const std::vector<std::vector<std::string>>& one_of);

/// The root of the table.
Description describe(Scenario& scenario);

}  // namespace alate
