#include "data/scenario_values.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/number_text.hpp"
#include "data/scenario_reader.hpp"
#include "data/scenario_text.hpp"

namespace alate {

Mark Findings::mark_at(const Place& place) const {
  if (place.line == 0) return {.file = kOverrideFile};
  return {.file = scenario_.file, .line = place.line, .column = place.column};
}

void Findings::report(const Place& place, Fault fault) {
  const Mark mark = mark_at(place);
  fault.file = mark.file;
  fault.line = mark.line;
  fault.column = mark.column;
  fault.field = shortened(fault.field);
  fault.value = shortened(fault.value);
  faults_.push_back(std::move(fault));
}

void Findings::report(const Value& value, std::string message, std::string limit) {
  report(value.node.place, {.field = value.path,
                            .value = value.node.text,
                            .limit = std::move(limit),
                            .unit = value.field.unit,
                            .message = std::move(message)});
}

bool is_kind(const Value& value, Node::Kind kind, const char* message, Findings& findings) {
  if (value.node.kind == kind) return true;
  findings.report(value, message);
  return false;
}

bool has_items(const Value& value, std::size_t least, std::size_t most, Findings& findings) {
  const std::size_t count = value.node.children.size();
  if (count >= least && count <= most) return true;
  findings.report(value.node.place,
                  {.field = value.path,
                   .value = fmt::format("{}", count),
                   .limit = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most),
                   .unit = "items",
                   .message = "has the wrong number of items"});
  return false;
}

namespace {

std::optional<double> finite_number(const Value& value, const Range& range, Findings& findings) {
  if (value.node.kind == Node::Kind::broken) return std::nullopt;
  if (!is_kind(value, Node::Kind::scalar, "must be a number", findings)) return std::nullopt;
  if (value.node.quoted) {
    findings.report(value, "must be a number, without quotes");
    return std::nullopt;
  }
  const NumberText number = parse_number(value.node.text);
  if (!number.problem.empty()) {
    findings.report(value, number.problem, range.text());
  } else if (std::abs(number.value) > kMaxMagnitude) {
    findings.report(value, "is too large", fmt::format("-{0} to {0}", kMaxMagnitude));
  } else if (!range.holds(number.value)) {
    findings.report(value, "out of range", range.text());
  } else {
    return number.value;
  }
  return std::nullopt;
}

/// Also true where no whole number is `asked` for.
bool is_whole(const Value& value, double number, bool asked, Findings& findings) {
  if (!asked || number == std::floor(number)) return true;
  findings.report(value, "must be a whole number");
  return false;
}

std::string resolved(const Node& node, const std::string& file) {
  const std::filesystem::path path = node.text;
  if (path.is_absolute() || node.place.line == 0) return node.text;
  return (std::filesystem::path(file).parent_path() / path).string();
}

}  // namespace

void read_value(const Value& value, const Text& slot, Findings& findings) {
  if (!is_kind(value, Node::Kind::scalar, "must be text", findings)) return;
  const std::string& text = value.node.text;
  const bool printable = std::ranges::none_of(text, [](char c) { return is_control(c) || c == '\n' || c == '\r'; });
  if (!printable) return findings.report(value, "must be one line without control characters");
  if (text.empty() && slot.use != Text::Use::label) return findings.report(value, "is empty");
  slot.set(slot.use == Text::Use::path ? resolved(value.node, findings.file()) : text);
}

void read_value(const Value& value, const Flag& slot, Findings& findings) {
  if (!is_kind(value, Node::Kind::scalar, "must be true or false", findings)) return;
  const std::string& text = value.node.text;
  if (value.node.quoted || (text != "true" && text != "false")) return findings.report(value, "must be true or false");
  slot.set(text == "true");
}

void read_value(const Value& value, const Number& slot, Findings& findings) {
  const auto number = finite_number(value, slot.range, findings);
  if (number && is_whole(value, *number, slot.whole, findings)) slot.set(*number);
}

void read_value(const Value& value, const Numbers& slot, Findings& findings) {
  if (!is_kind(value, Node::Kind::list, "must be a list of numbers", findings)) return;
  if (!has_items(value, slot.least(), slot.most(), findings)) return;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value.node.children.size(); ++i) {
    const Node& child = value.node.children[i];
    const std::string path = join(value.path, std::to_string(i));
    findings.mark(path, child.place);
    const Value item{child, path, value.field};
    const auto number = finite_number(item, slot.range, findings);
    if (number && is_whole(item, *number, slot.whole, findings)) numbers.push_back(*number);
  }
  if (numbers.size() == value.node.children.size()) slot.set(numbers);
}

void read_value(const Value& value, const Choice& slot, Findings& findings) {
  if (!is_kind(value, Node::Kind::scalar, "must be a word", findings)) return;
  const auto found = std::ranges::find(slot.words, value.node.text);
  if (found == slot.words.end())
    return findings.report(value, "unknown word", fmt::format("{}", fmt::join(slot.words, " | ")));
  slot.set(static_cast<std::size_t>(found - slot.words.begin()));
}

void read_value(const Value& value, const Words& slot, Findings& findings) {
  if (!is_kind(value, Node::Kind::map, "must be a group of keys", findings)) return;
  for (const Node& child : value.node.children) {
    const std::string path = join(value.path, child.key);
    findings.mark(path, child.place);
    const Text text{.set = [&](std::string given) { (*slot.values)[child.key] = std::move(given); }};
    if (child.kind == Node::Kind::null) {
      findings.report(child.key_place, {.field = path, .message = "has no value"});
    } else if (child.kind != Node::Kind::broken) {
      read_value({child, path, value.field}, text, findings);
    }
  }
}

}  // namespace alate
