// Lists of the points that are worth flying to next.
#pragma once

#include <span>
#include <vector>

#include "space/relaxed_to_go.hpp"

namespace alate {

/// For every node the nodes that may follow it at best, with no error carried in: those with the least length of the
/// leg plus relaxed rest, best first, ties by index. The goal is always among them if it is in reach.
class Successors {
 public:
  using Node = CorrectionGraph::Node;
  struct Arc {
    Node to = 0;
    double length_m = 0;
  };

  /// At most `most` a node. Lists are made in parallel; where `run` ends that they are not complete.
  Successors(const CorrectionGraph& graph, const RelaxedToGo& to_go, std::size_t most, RunContext& run);

  std::span<const Arc> of(Node i) const { return lists_[i]; }
  /// Length of the longest list.
  std::size_t longest() const { return longest_; }

 private:
  std::vector<std::vector<Arc>> lists_;
  std::size_t longest_ = 0;
};

}  // namespace alate
