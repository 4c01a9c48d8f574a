// What searches over a Space have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "space/space.hpp"

namespace alate {

/// A string of actions from the start, or nothing and how near the search came.
struct SearchResult {
  bool found = false;
  std::vector<std::size_t> actions;
  double cost = kInfinity;
  std::uint64_t expansions = 0;
  std::uint64_t candidates = 0;
};

/// Tree of moves; a node knows its parent and the action that led to it. Node 0 is the start.
class MoveTree {
 public:
  MoveTree() : nodes_{{0, 0}} {}

  std::uint32_t add(std::uint32_t parent, std::size_t action) {
    nodes_.push_back({parent, static_cast<std::uint32_t>(action)});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  /// Actions from the start to `node`.
  std::vector<std::size_t> path_to(std::uint32_t node) const {
    std::vector<std::size_t> actions;
    for (; node != 0; node = nodes_[node].parent) actions.push_back(nodes_[node].action);
    return {actions.rbegin(), actions.rend()};
  }

 private:
  struct Node {
    std::uint32_t parent;
    std::uint32_t action;
  };
  std::vector<Node> nodes_;
};

}  // namespace alate
