// Ranges `a..b` in study files: they stand for the list from a to b.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/scenario_document.hpp"

namespace alate {

/// Both ends, whole numbers; nothing if the text is no range. The second may be below the first, which is a fault.
std::optional<std::pair<std::int64_t, std::int64_t>> range_of(const Node& node);

/// A tree with one number for each of its ranges.
struct Expanded {
  Node node;
  std::string chosen;  ///< "grid.random.seed=7", by a blank between several; empty without ranges.
};

/// How many trees `node` stands for; 0 where a range runs backwards or there are more than `most`.
std::uint64_t expanded_count(const Node& node, std::uint64_t most);

/// The trees, the last range changing fastest. `expanded_count` must be fine.
std::vector<Expanded> expand(const Node& node);

}  // namespace alate
