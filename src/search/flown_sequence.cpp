#include "search/flown_sequence.hpp"

#include <algorithm>

#include "search/label_setting/label_queue.hpp"
#include "space/candidates.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr std::uint64_t kPollEvery = 1024;

struct PairLabel {
  double cost = 0;
  double error = 0;
  Node before = 0;
  Node node = 0;
  std::uint32_t parent = 0;
};

class SequenceSearch {
 public:
  SequenceSearch(const CorrectionGraph& graph, const FlownLegs& flown, const SequenceOptions& options)
      : graph_(graph), flown_(flown), options_(options) {}

  std::optional<std::vector<Node>> find(RunContext& run) {
    add({.before = graph_.start(), .node = graph_.start()});
    for (std::uint64_t pops = 1; !open_.empty(); ++pops) {
      if (pops % kPollEvery == 0 && !run.keep_going()) return std::nullopt;
      const std::uint32_t at = open_.pop().label;
      if (labels_[at].node == graph_.goal()) return way_to(at);
      if (is_dominated(labels_[at])) continue;
      expand(at);
    }
    return std::nullopt;
  }

 private:
  /// Labels come out at each pair in the order of their costs.
  bool is_dominated(const PairLabel& label) {
    const auto [least, is_new] = least_error_.try_emplace({label.before, label.node}, label.error);
    if (is_new) return false;
    if (least->second <= label.error) return true;
    least->second = label.error;
    return false;
  }

  void expand(std::uint32_t at) {
    const PairLabel from = labels_[at];
    const auto go = [&](Node to, double straight_m) {
      const FlownLegPrice* known = flown_.find(from.before, from.node, to);
      const double length = known != nullptr ? known->length_m : straight_m;
      const ReducedLeg& rule = graph_.leg(from.node, to);
      if (!(length < kInfinity) || !rule.keeps_limits(from.error, length)) return;
      add({.cost = from.cost + (known != nullptr ? known->cost : options_.metre_cost * straight_m),
           .error = rule.after(from.error, length),
           .before = from.node,
           .node = to,
           .parent = at});
    };
    graph_.for_each_next(from.node, from.error, [&](Node to, double length, double /*after*/) { go(to, length); });
    go(graph_.goal(), least_to_goal(from.node));
  }

  double least_to_goal(Node node) const { return std::max(0.0, graph_.to_goal(node) - options_.goal_within_m); }

  void add(const PairLabel& label) {
    open_.push(label.cost + options_.metre_cost * least_to_goal(label.node),
               static_cast<std::uint32_t>(labels_.size()));
    labels_.push_back(label);
  }

  std::vector<Node> way_to(std::uint32_t at) const {
    std::vector<Node> nodes;
    for (; labels_[at].node != graph_.start(); at = labels_[at].parent) nodes.push_back(labels_[at].node);
    nodes.push_back(graph_.start());
    std::ranges::reverse(nodes);
    return nodes;
  }

  const CorrectionGraph& graph_;
  const FlownLegs& flown_;
  SequenceOptions options_;
  std::vector<PairLabel> labels_;
  LabelQueue open_;
  std::map<std::array<Node, 2>, double> least_error_;
};

}  // namespace

std::optional<std::vector<Node>> cheapest_sequence(const CorrectionGraph& graph, const FlownLegs& flown,
                                                   const SequenceOptions& options, RunContext& run) {
  return SequenceSearch(graph, flown, options).find(run);
}

}  // namespace alate
