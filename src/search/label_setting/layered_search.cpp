#include "search/label_setting/layered_search.hpp"

#include <utility>

namespace alate {

using Node = CorrectionGraph::Node;

LayeredSearch::LayeredSearch(const CorrectionGraph& graph, const Bounds& bounds, const LengthCaps& caps)
    : graph_(graph),
      bounds_(bounds),
      caps_(caps),
      stairs_(graph.size()),
      best_(caps.most_m.size(), Label{.length_m = kInfinity}) {}

void LayeredSearch::run(RunContext& run) {
  pool_.push_back({.node = graph_.start()});
  dominated_.push_back(false);
  std::vector<std::uint32_t> layer{0};
  for (int corrections = 0; !layer.empty(); ++corrections) {
    for (const std::uint32_t index : layer) {
      if (dominated_[index]) continue;
      if (expanded_++ % kPollEvery == 0 && !run.keep_going()) {
        stopped_ = true;
        return;
      }
      expand(index, corrections);
    }
    layer.swap(next_);
    next_.clear();
  }
}

CorrectionRoute LayeredSearch::route(std::size_t i) const {
  return {best_[i].length_m, points_to(graph_, pool_, best_[i].parent)};
}

void LayeredSearch::expand(std::uint32_t index, int corrections) {
  const Label from = pool_[index];
  fly_home(index, from);
  graph_.for_each_next(from.node, from.error, [&](Node j, double d, double error) {
    const Label next{from.length_m + d, error, j, index, corrections + 1};
    if (!can_lead_home(j, next) || stairs_.dominates(j, next.length_m, error) || !graph_.is_free(from.node, j)) return;
    const auto label = static_cast<std::uint32_t>(pool_.size());
    stairs_.insert(j, {next.length_m, error, label}, [&](std::uint32_t worse) {
      if (pool_[worse].corrections == corrections + 1) dominated_[worse] = true;
    });
    pool_.push_back(next);
    dominated_.push_back(false);
    next_.push_back(label);
  });
}

void LayeredSearch::fly_home(std::uint32_t index, const Label& from) {
  const Node goal = graph_.goal();
  const double home = graph_.to_goal(from.node);
  const double length = from.length_m + home;
  if (from.corrections > caps_.most() || !graph_.leg(from.node, goal).keeps_limits(from.error, home)) return;
  const auto first = static_cast<std::size_t>(std::max(0, from.corrections - caps_.fewest));
  if (length >= best_[first].length_m || !graph_.is_free(from.node, goal)) return;
  for (std::size_t i = first; i < best_.size() && length < best_[i].length_m; ++i) {
    best_[i] = {length, 0, goal, index, from.corrections};
    // What was found is a cap, and never undercuts the ones for more corrections.
    caps_.most_m[i] = std::min(caps_.most_m[i], length * (1 + kRounding));
  }
}

/// Within a cap, by the bounds on what is left?
bool LayeredSearch::can_lead_home(Node j, const Label& label) const {
  const double straight = graph_.to_goal(j);
  if (label.length_m + straight > caps_.most_m.front()) return false;
  const int corrections = bounds_.corrections.in_all(j, label.error, label.corrections);
  if (corrections > caps_.most()) return false;
  const double most = caps_.most_m[static_cast<std::size_t>(std::max(0, corrections - caps_.fewest))];
  if (label.length_m + straight > most) return false;
  return bounds_.length == nullptr || label.length_m + bounds_.length->at(j, label.error) <= most;
}

}  // namespace alate
