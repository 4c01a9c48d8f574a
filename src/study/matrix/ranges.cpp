#include "study/matrix/ranges.hpp"

#include <fmt/core.h>

#include <cmath>
#include <tuple>

#include "core/number_text.hpp"
#include "data/limits.hpp"

namespace alate {

namespace {

std::optional<std::int64_t> whole_number(std::string_view text) {
  const NumberText number = parse_number(text);
  if (!number.problem.empty() || number.value != std::floor(number.value) || std::abs(number.value) > kMaxMagnitude)
    return std::nullopt;
  return static_cast<std::int64_t>(number.value);
}

/// Ranges in the order of the text.
struct Found {
  std::vector<std::size_t> way;  ///< Indices of children.
  std::string path;
  std::int64_t from = 0;
  std::int64_t to = 0;
};

void find_ranges(const Node& node, const Found& here, std::vector<Found>& found) {
  if (const auto range = range_of(node)) {
    Found& one = found.emplace_back(here);
    std::tie(one.from, one.to) = *range;
  }
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const std::string name = node.kind == Node::Kind::list ? std::to_string(i) : node.children[i].key;
    Found next{.way = here.way, .path = here.path.empty() ? name : here.path + "." + name};
    next.way.push_back(i);
    find_ranges(node.children[i], next, found);
  }
}

Node& child_at(Node& root, const std::vector<std::size_t>& way) {
  Node* node = &root;
  for (const std::size_t index : way) node = &node->children[index];
  return *node;
}

}  // namespace

std::optional<std::pair<std::int64_t, std::int64_t>> range_of(const Node& node) {
  if (node.kind != Node::Kind::scalar || node.quoted) return std::nullopt;
  const std::size_t dots = node.text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  const auto from = whole_number(std::string_view(node.text).substr(0, dots));
  const auto to = whole_number(std::string_view(node.text).substr(dots + 2));
  if (!from || !to) return std::nullopt;
  return std::pair(*from, *to);
}

std::uint64_t expanded_count(const Node& node, std::uint64_t most) {
  std::vector<Found> found;
  find_ranges(node, {}, found);
  std::uint64_t count = 1;
  for (const Found& range : found) {
    if (range.to < range.from) return 0;
    const auto items = static_cast<std::uint64_t>(range.to - range.from) + 1;
    if (items > most / count) return 0;
    count *= items;
  }
  return count;
}

std::vector<Expanded> expand(const Node& node) {
  std::vector<Found> found;
  find_ranges(node, {}, found);
  std::vector<Expanded> all{{.node = node, .chosen = {}}};
  for (const Found& range : found) {
    std::vector<Expanded> more;
    for (const Expanded& each : all) {
      for (std::int64_t value = range.from; value <= range.to; ++value) {
        Expanded& one = more.emplace_back(each);
        child_at(one.node, range.way).text = std::to_string(value);
        one.chosen += fmt::format("{}{}={}", one.chosen.empty() ? "" : " ", range.path, value);
      }
    }
    all = std::move(more);
  }
  return all;
}

}  // namespace alate
