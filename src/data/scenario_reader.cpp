#include "data/scenario_reader.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "alate/core/param_table.hpp"
#include "data/scenario_values.hpp"

namespace alate {

namespace {

class Reader {
 public:
  explicit Reader(const Findings& findings) : findings_(findings) {}

  void read_group(const Node& node, const std::string& path, const Description& description);

 private:
  template <class Slot>
  void read(const Value& value, const Slot& slot) {
    read_value(value, slot, findings_);
  }
  void read(const Value& value, const Group& slot);
  void read(const Value& value, const Groups& slot);
  void read(const Value& value, const FileOrGroups& slot);
  void check_keys(const Node& node, const std::string& path, const Description& description);
  void check_one_of(const Node& node, const std::string& path, const Description& description);

  Findings findings_;
};

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
      const bool needless = !field.unless.empty() && node.find(field.unless) != nullptr;
      if (field.required && !needless)
        findings_.report(place_of_group(node), {.field = child_path, .message = "is missing"});
      continue;
    }
    findings_.mark(child_path, holds_fields(field.slot) ? child->key_place : child->place);
    if (child->kind == Node::Kind::broken) continue;
    if (child->kind == Node::Kind::null) {
      findings_.report(child->key_place, {.field = child_path, .message = "has no value"});
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
    findings_.report(child.key_place,
                     {.field = join(path, child.key),
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
  findings_.report(place_of_group(node),
                   {.field = path,
                    .value = given.empty() ? "none of them" : fmt::format("{}", fmt::join(given, ", ")),
                    .limit = text_of(description.one_of),
                    .message = "needs exactly one of these sets of keys"});
}

void Reader::read(const Value& value, const Group& slot) {
  if (is_kind(value, Node::Kind::map, "must be a group of keys", findings_))
    read_group(value.node, value.path, slot.open());
}

void Reader::read(const Value& value, const Groups& slot) {
  if (!is_kind(value, Node::Kind::list, "must be a list of groups", findings_)) return;
  if (!has_items(value, slot.least, kMaxListItems, findings_)) return;
  for (std::size_t i = 0; i < value.node.children.size(); ++i) {
    const Node& child = value.node.children[i];
    const std::string path = join(value.path, std::to_string(i));
    findings_.mark(path, child.place);
    if (child.kind != Node::Kind::broken) read({child, path, value.field}, Group{.open = [&] { return slot.at(i); }});
  }
}

void Reader::read(const Value& value, const FileOrGroups& slot) {
  if (value.node.kind == Node::Kind::list) {
    read(value, slot.items);
  } else if (is_kind(value, Node::Kind::scalar, "must be the name of a file or a list of groups", findings_)) {
    read(value, slot.file);
  }
}

}  // namespace

void read_scenario(const Node& root, Scenario& scenario, std::vector<Fault>& faults) {
  Reader({scenario, faults}).read_group(root, "", describe(scenario));
}

}  // namespace alate
