#include "data/scenario_reader.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "alate/core/param_table.hpp"
#include "core/number_text.hpp"
#include "data/scenario_fields.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

class Reader {
 public:
  Reader(Scenario& scenario, std::vector<Fault>& faults) : scenario_(scenario), faults_(faults) {}

  void read_group(const Node& node, const std::string& path, const Description& description);

 private:
  /// One value under its dotted path, with the field it is read for.
  struct Value {
    const Node& node;
    const std::string& path;
    const Field& field;
  };

  void read(const Value& value, const Text& slot);
  void read(const Value& value, const Flag& slot);
  void read(const Value& value, const Number& slot);
  void read(const Value& value, const Numbers& slot);
  void read(const Value& value, const Choice& slot);
  void read(const Value& value, const Group& slot);
  void read(const Value& value, const Groups& slot);
  void read(const Value& value, const Words& slot);

  bool is_kind(const Value& value, Node::Kind kind, const char* message);
  bool has_items(const Value& value, std::size_t least, std::size_t most);
  std::optional<double> finite_number(const Value& value, const Range& range);
  std::string resolved(const Node& node) const;
  void check_keys(const Node& node, const std::string& path, const Description& description);
  void check_one_of(const Node& node, const std::string& path, const Description& description);

  Mark mark_at(const Place& place) const {
    if (place.line == 0) return {.file = kOverrideFile};
    return {.file = scenario_.file, .line = place.line, .column = place.column};
  }
  void report(const Place& place, Fault fault) {
    const Mark mark = mark_at(place);
    fault.file = mark.file;
    fault.line = mark.line;
    fault.column = mark.column;
    fault.field = shortened(fault.field);
    fault.value = shortened(fault.value);
    faults_.push_back(std::move(fault));
  }
  void report(const Value& value, std::string message, std::string limit = "") {
    report(value.node.place, {.field = value.path,
                              .value = value.node.text,
                              .limit = std::move(limit),
                              .unit = value.field.unit,
                              .message = std::move(message)});
  }

  Scenario& scenario_;
  std::vector<Fault>& faults_;
};

std::string join(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

/// Where a missing key or a wrong combination is reported: at the group's key, or at the item of a list.
const Place& place_of_group(const Node& node) { return node.key.empty() ? node.place : node.key_place; }

/// A group is marked by its key, a value by itself.
bool holds_fields(const Slot& slot) {
  return std::holds_alternative<Group>(slot) || std::holds_alternative<Groups>(slot);
}

void Reader::read_group(const Node& node, const std::string& path, const Description& description) {
  check_keys(node, path, description);
  for (const Field& field : description.fields) {
    const Node* child = node.find(field.key);
    const std::string child_path = join(path, field.key);
    if (child == nullptr) {
      if (field.required) report(place_of_group(node), {.field = child_path, .message = "is missing"});
      continue;
    }
    scenario_.marks[child_path] = mark_at(holds_fields(field.slot) ? child->key_place : child->place);
    if (child->kind == Node::Kind::broken) continue;
    if (child->kind == Node::Kind::null) {
      report(child->key_place, {.field = child_path, .message = "has no value"});
      continue;
    }
    std::visit([&](const auto& slot) { read({*child, child_path, field}, slot); }, field.slot);
  }
  check_one_of(node, path, description);
}

void Reader::check_keys(const Node& node, const std::string& path, const Description& description) {
  std::vector<std::string> known;
  for (const Field& field : description.fields) known.push_back(field.key);
  for (const Node& child : node.children) {
    if (std::ranges::find(known, child.key) != known.end()) continue;
    const std::string near = nearest(child.key, known);
    report(child.key_place, {.field = join(path, child.key),
                             .limit = near.empty() ? fmt::format("{}", fmt::join(known, ", ")) : "",
                             .message = "unknown key" + (near.empty() ? "" : "; did you mean " + near + "?")});
  }
}

void Reader::check_one_of(const Node& node, const std::string& path, const Description& description) {
  std::vector<std::string> given;
  for (const Field& field : description.fields) {
    const bool matters = std::ranges::any_of(description.one_of, [&](const std::vector<std::string>& keys) {
      return std::ranges::find(keys, field.key) != keys.end();
    });
    if (matters && node.find(field.key) != nullptr) given.push_back(field.key);
  }
  const bool whole = std::ranges::any_of(description.one_of, [&](const std::vector<std::string>& keys) {
    return std::ranges::is_permutation(keys, given);
  });
  if (whole || description.one_of.empty()) return;
  report(place_of_group(node), {.field = path,
                                .value = given.empty() ? "none of them" : fmt::format("{}", fmt::join(given, ", ")),
                                .limit = text_of(description.one_of),
                                .message = "needs exactly one of these sets of keys"});
}

bool Reader::is_kind(const Value& value, Node::Kind kind, const char* message) {
  if (value.node.kind == kind) return true;
  report(value, message);
  return false;
}

bool Reader::has_items(const Value& value, std::size_t least, std::size_t most) {
  const std::size_t count = value.node.children.size();
  if (count >= least && count <= most) return true;
  report(value.node.place, {.field = value.path,
                            .value = fmt::format("{}", count),
                            .limit = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most),
                            .unit = "items",
                            .message = "has the wrong number of items"});
  return false;
}

std::optional<double> Reader::finite_number(const Value& value, const Range& range) {
  if (value.node.kind == Node::Kind::broken) return std::nullopt;
  if (!is_kind(value, Node::Kind::scalar, "must be a number")) return std::nullopt;
  if (value.node.quoted) {
    report(value, "must be a number, without quotes");
    return std::nullopt;
  }
  const NumberText number = parse_number(value.node.text);
  if (!number.problem.empty()) {
    report(value, number.problem, range.text());
  } else if (std::abs(number.value) > kMaxMagnitude) {
    report(value, "is too large", fmt::format("-{0} to {0}", kMaxMagnitude));
  } else if (!range.holds(number.value)) {
    report(value, "out of range", range.text());
  } else {
    return number.value;
  }
  return std::nullopt;
}

std::string Reader::resolved(const Node& node) const {
  const std::filesystem::path path = node.text;
  if (path.is_absolute() || node.place.line == 0) return node.text;
  return (std::filesystem::path(scenario_.file).parent_path() / path).string();
}

void Reader::read(const Value& value, const Text& slot) {
  if (!is_kind(value, Node::Kind::scalar, "must be text")) return;
  const std::string& text = value.node.text;
  const bool printable = std::ranges::none_of(text, [](char c) { return is_control(c) || c == '\n' || c == '\r'; });
  if (!printable) return report(value, "must be one line without control characters");
  if (text.empty() && slot.use != Text::Use::label) return report(value, "is empty");
  slot.set(slot.use == Text::Use::path ? resolved(value.node) : text);
}

void Reader::read(const Value& value, const Flag& slot) {
  if (!is_kind(value, Node::Kind::scalar, "must be true or false")) return;
  const std::string& text = value.node.text;
  if (value.node.quoted || (text != "true" && text != "false")) return report(value, "must be true or false");
  slot.set(text == "true");
}

void Reader::read(const Value& value, const Number& slot) {
  if (const auto number = finite_number(value, slot.range)) slot.set(*number);
}

void Reader::read(const Value& value, const Numbers& slot) {
  if (!is_kind(value, Node::Kind::list, "must be a list of numbers")) return;
  if (!has_items(value, std::max<std::size_t>(slot.count, 1), slot.count > 0 ? slot.count : kMaxAngles)) return;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value.node.children.size(); ++i) {
    const Node& child = value.node.children[i];
    const std::string path = join(value.path, std::to_string(i));
    scenario_.marks[path] = mark_at(child.place);
    if (const auto number = finite_number({child, path, value.field}, slot.range)) numbers.push_back(*number);
  }
  if (numbers.size() == value.node.children.size()) slot.set(numbers);
}

void Reader::read(const Value& value, const Choice& slot) {
  if (!is_kind(value, Node::Kind::scalar, "must be a word")) return;
  const auto found = std::ranges::find(slot.words, value.node.text);
  if (found == slot.words.end()) return report(value, "unknown word", fmt::format("{}", fmt::join(slot.words, " | ")));
  slot.set(static_cast<std::size_t>(found - slot.words.begin()));
}

void Reader::read(const Value& value, const Group& slot) {
  if (is_kind(value, Node::Kind::map, "must be a group of keys")) read_group(value.node, value.path, slot.open());
}

void Reader::read(const Value& value, const Groups& slot) {
  if (!is_kind(value, Node::Kind::list, "must be a list of groups")) return;
  if (!has_items(value, 0, kMaxListItems)) return;
  for (std::size_t i = 0; i < value.node.children.size(); ++i) {
    const Node& child = value.node.children[i];
    const std::string path = join(value.path, std::to_string(i));
    scenario_.marks[path] = mark_at(child.place);
    if (child.kind != Node::Kind::broken) read({child, path, value.field}, Group{.open = [&] { return slot.at(i); }});
  }
}

void Reader::read(const Value& value, const Words& slot) {
  if (!is_kind(value, Node::Kind::map, "must be a group of keys")) return;
  for (const Node& child : value.node.children) {
    const std::string path = join(value.path, child.key);
    scenario_.marks[path] = mark_at(child.place);
    const Text text{.set = [&](std::string given) { (*slot.values)[child.key] = std::move(given); }};
    if (child.kind == Node::Kind::null) {
      report(child.key_place, {.field = path, .message = "has no value"});
    } else if (child.kind != Node::Kind::broken) {
      read({child, path, value.field}, text);
    }
  }
}

}  // namespace

void read_scenario(const Node& root, Scenario& scenario, std::vector<Fault>& faults) {
  Reader(scenario, faults).read_group(root, "", describe(scenario));
}

}  // namespace alate
