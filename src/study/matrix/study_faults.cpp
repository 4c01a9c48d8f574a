#include "study/matrix/study_faults.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "alate/core/param_table.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"

namespace alate {

void StudyFaults::report(const Place& place, Fault fault) {
  fault.file = file_;
  fault.line = place.line;
  fault.column = place.column;
  fault.field = shortened(fault.field);
  fault.value = shortened(fault.value);
  faults_.push_back(std::move(fault));
}

void StudyFaults::take(std::vector<Fault> faults, const std::string& field) {
  for (Fault& fault : faults) {
    if (fault.file == file_ && !field.empty()) fault.field = fault.field.empty() ? field : field + "." + fault.field;
    faults_.push_back(std::move(fault));
  }
}

void StudyFaults::check_keys(const Node& map, const std::string& field, const std::vector<std::string>& known) {
  for (const Node& child : map.children) {
    if (std::ranges::find(known, child.key) != known.end()) continue;
    const std::string near = nearest(child.key, known);
    report(child.key_place, {.field = field.empty() ? child.key : field + "." + child.key,
                             .limit = near.empty() ? fmt::format("{}", fmt::join(known, ", ")) : "",
                             .message = "unknown key" + (near.empty() ? "" : "; did you mean " + near + "?")});
  }
}

bool StudyFaults::is_list(const Node* node, const Node& around, const std::string& field, std::size_t most) {
  if (node == nullptr) {
    report(around.place, {.field = field, .message = "is missing"});
    return false;
  }
  if (node->kind == Node::Kind::broken) return false;
  if (node->kind != Node::Kind::list) {
    report(node->key_place, {.field = field, .value = node->text, .message = "must be a list"});
    return false;
  }
  const std::size_t count = node->children.size();
  if (count >= 1 && count <= most) return true;
  report(node->place, {.field = field,
                       .value = fmt::format("{}", count),
                       .limit = fmt::format("1 to {}", most),
                       .unit = "items",
                       .message = count == 0 ? "is an empty list" : "has too many items"});
  return false;
}

bool StudyFaults::is_word(const Node& node, const std::string& field) {
  if (node.kind == Node::Kind::scalar && !node.text.empty()) return true;
  if (node.kind != Node::Kind::broken) report(node.place, {.field = field, .message = "must be a word"});
  return false;
}

void StudyFaults::throw_if_any() {
  std::ranges::stable_sort(faults_, {}, [](const Fault& fault) { return std::tie(fault.line, fault.column); });
  if (faults_.size() > kMaxFaults) {
    const std::size_t more = faults_.size() - kMaxFaults;
    faults_.resize(kMaxFaults);
    faults_.push_back({.file = file_, .message = fmt::format("and {} more faults", more)});
  }
  alate::throw_if_any(std::move(faults_));
}

}  // namespace alate
