// Which correction points to fly over where the length of a leg is known once it has been flown.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "alate/core/run_context.hpp"
#include "space/correction_graph.hpp"

namespace alate {

/// A leg as it was flown; both infinite where it cannot be.
struct FlownLegPrice {
  double length_m = 0;
  double cost = 0;
};

/// Legs by three points: how a leg is flown depends on the heading with which the leg before ended.
class FlownLegs {
 public:
  using Node = CorrectionGraph::Node;

  void note(Node before, Node from, Node to, const FlownLegPrice& price) { known_[{before, from, to}] = price; }
  /// Nothing where the leg has not been flown.
  const FlownLegPrice* find(Node before, Node from, Node to) const {
    const auto found = known_.find({before, from, to});
    return found == known_.end() ? nullptr : &found->second;
  }

 private:
  std::map<std::array<Node, 3>, FlownLegPrice> known_;
};

struct SequenceOptions {
  double metre_cost = 1;     ///< Of legs that have not been flown.
  double goal_within_m = 0;  ///< They may end so far before the goal.
};

/// A* on labels (cost, error) at pairs of points, the last two of a way: the cheapest way from start to goal whose
/// errors keep their limits, nodes in order with both ends. Legs that have been flown count as flown, all others as
/// straight: so no way is cheaper. Nothing where there is none, or `run` ends it.
///
/// The labels of Zhou et al. 2020 made exact, as in label_setting/shortest.hpp; with the point before in the state.
std::optional<std::vector<CorrectionGraph::Node>> cheapest_sequence(const CorrectionGraph& graph,
                                                                    const FlownLegs& flown,
                                                                    const SequenceOptions& options, RunContext& run);

}  // namespace alate
