#include "data/scenario_override.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "data/limits.hpp"
#include "data/scenario_reader.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

std::optional<std::size_t> index_of(const std::string& part) {
  std::size_t index = 0;
  const char* end = part.data() + part.size();
  const auto [stopped, error] = std::from_chars(part.data(), end, index);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return index;
}

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::stringstream stream(path + ".");
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

void forget_places(Node& node) {
  node.place = node.key_place = {};
  for (Node& child : node.children) forget_places(child);
}

/// The child named by `part`, made where it is missing; or why there is none.
struct Step {
  Node* node = nullptr;
  std::string problem;
};

Step step_into(Node& node, const std::string& part) {
  const auto index = index_of(part);
  if (node.kind == Node::Kind::null) node.kind = index == 0U ? Node::Kind::list : Node::Kind::map;
  if (node.kind == Node::Kind::map) {
    if (Node* found = node.find(part)) return {.node = found};
    return {.node = &node.children.emplace_back(Node{.key = part})};
  }
  if (node.kind != Node::Kind::list) return {.problem = "leads through a plain value"};
  const std::size_t size = node.children.size();
  if (!index || *index > size) return {.problem = fmt::format("the list takes an index from 0 to {}", size)};
  if (*index == size) node.children.emplace_back();
  return {.node = &node.children[*index]};
}

}  // namespace

void apply_override(const std::string& text, Node& root, std::vector<Fault>& faults) {
  const auto refuse = [&](std::string message) {
    faults.push_back({.file = kOverrideFile, .value = shortened(text), .message = std::move(message)});
  };
  const std::size_t equals = text.find('=');
  const std::vector<std::string> parts = parts_of(text.substr(0, equals));
  if (equals == std::string::npos || std::ranges::find(parts, "") != parts.end())
    return refuse("must read key.path=VALUE");
  if (parts.size() > kMaxNesting) return refuse(fmt::format("names more than {} levels", kMaxNesting));

  const std::string yaml = text.substr(equals + 1);
  std::vector<Fault> value_faults;
  check_scenario_text(yaml, kOverrideFile, value_faults);
  Node value = value_faults.empty() ? parse_document(yaml, kOverrideFile, value_faults) : Node{};
  if (!value_faults.empty()) return refuse(value_faults.front().message);
  forget_places(value);

  Node* target = &root;
  for (const std::string& part : parts) {
    const Step step = step_into(*target, part);
    if (step.node == nullptr) return refuse(step.problem);
    target = step.node;
  }
  value.key = target->key;
  *target = std::move(value);
}

}  // namespace alate
