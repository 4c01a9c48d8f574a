#include "space/relaxed_to_go.hpp"

#include <queue>

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr double kAnyError = std::numeric_limits<double>::infinity();

struct Reached {
  double key = 0;
  double to_go = 0;
  Node node = 0;
  bool operator>(const Reached& other) const { return key > other.key || (key == other.key && node > other.node); }
};

}  // namespace

RelaxedToGo::RelaxedToGo(const CorrectionGraph& graph, Extent extent, RunContext& run)
    : to_go_(graph.size(), std::numeric_limits<double>::infinity()) {
  std::vector<double> best = to_go_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  best[graph.goal()] = 0;
  const auto open_node = [&](Node i, double to_go) {
    const double ahead = extent == Extent::until_start ? graph.from_start(i) : 0;
    open.push({to_go + ahead, to_go, i});
  };
  open_node(graph.goal(), 0);
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
    graph.for_each_previous(now.node, kAnyError, [&](Node i, double length, double /*most*/) {
      if (!(now.to_go + length < best[i])) return;
      best[i] = now.to_go + length;
      open_node(i, best[i]);
    });
  }
}

}  // namespace alate
