#include "space/successors.hpp"

namespace alate {

namespace {

std::vector<Successors::Arc> list_of(const CorrectionGraph& graph, const RelaxedToGo& to_go, CorrectionGraph::Node i,
                                     std::size_t most) {
  std::vector<Successors::Arc> list;
  graph.for_each_next(i, 0, [&](CorrectionGraph::Node j, double length, double /*error*/) {
    if (to_go(j) < std::numeric_limits<double>::infinity()) list.push_back({j, length});
  });
  const double home = graph.length(i, graph.goal());
  if (home <= graph.leg(i, graph.goal()).reach_m(0)) list.push_back({graph.goal(), home});
  std::ranges::sort(list, {},
                    [&](const Successors::Arc& arc) { return std::pair(arc.length_m + to_go(arc.to), arc.to); });
  if (list.size() > most) {
    const auto goal = std::ranges::find(list, graph.goal(), &Successors::Arc::to);
    if (goal != list.end())
      std::swap(list[std::min<std::size_t>(most - 1, static_cast<std::size_t>(goal - list.begin()))], *goal);
    list.resize(most);
  }
  return list;
}

}  // namespace

Successors::Successors(const CorrectionGraph& graph, const RelaxedToGo& to_go, std::size_t most, RunContext& run)
    : lists_(graph.size()) {
  constexpr std::size_t kPollEvery = 256;
  run.executor().for_ranges(graph.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i % kPollEvery == 0 && !run.keep_going()) return;
      if (i != graph.goal()) lists_[i] = list_of(graph, to_go, static_cast<Node>(i), most);
    }
  });
  for (const auto& list : lists_) longest_ = std::max(longest_, list.size());
}

}  // namespace alate
