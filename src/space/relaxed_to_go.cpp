#include "space/relaxed_to_go.hpp"

#include <queue>

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

struct Reached {
  double to_go = 0;
  Node node = 0;
  bool operator>(const Reached& other) const {
    return to_go > other.to_go || (to_go == other.to_go && node > other.node);
  }
};

/// Calls visit(i, length) for all nodes from which an aircraft without error can fly to `j`.
template <class Visit>
void for_predecessors(const CorrectionGraph& graph, Node j, const Visit& visit) {
  for (const PointKind kind : {PointKind::vertical, PointKind::horizontal}) {
    const double reach = graph.leg(kind, graph.kind(j)).reach_m(0);
    graph.near(j, kind, reach, [&](Node first, Node last) {
      for (Node i = first; i < last; ++i)
        if (const double length = graph.length(i, j); length <= reach && i != j) visit(i, length);
    });
  }
  const double length = graph.length(graph.start(), j);
  if (length <= graph.leg(graph.start(), j).reach_m(0)) visit(graph.start(), length);
}

}  // namespace

RelaxedToGo::RelaxedToGo(const CorrectionGraph& graph, Extent extent, RunContext& run)
    : to_go_(graph.size(), std::numeric_limits<double>::infinity()) {
  std::vector<double> best = to_go_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  best[graph.goal()] = 0;
  open.push({0, graph.goal()});
  constexpr std::uint64_t kPollEvery = 1024;
  for (std::uint64_t count = 0; !open.empty(); ++count) {
    if (count % kPollEvery == 0 && !run.keep_going()) {
      stopped_ = true;
      return;
    }
    const Reached now = open.top();
    open.pop();
    if (now.to_go > best[now.node]) continue;
    to_go_[now.node] = now.to_go;
    if (now.node == graph.start()) {
      if (extent == Extent::until_start) return;
      continue;
    }
    for_predecessors(graph, now.node, [&](Node i, double length) {
      if (!(now.to_go + length < best[i])) return;
      best[i] = now.to_go + length;
      open.push({best[i], i});
    });
  }
}

}  // namespace alate
