#include "search/label_setting/remaining.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "search/label_setting/label.hpp"
#include "search/label_setting/label_queue.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

/// Longest d1 + d2 such that d1 <= most1, d2 <= most2 and rate1 d1 + rate2 d2 <= limit: at a corner of this polygon.
/// most2 alone keeps the limit.
struct TwoLegs {
  double most1 = 0;
  double most2 = 0;
  double rate1 = 0;
  double rate2 = 0;
  double limit = 0;

  double longest() const {
    return std::max({most1 + std::min(most2, rest(limit - rate1 * most1, rate2)), std::min(most1, rest(limit, rate1)),
                     most2 + std::min(most1, rest(limit - rate2 * most2, rate1))});
  }
  /// -infinity where the other leg alone breaks the limit: not a corner.
  static double rest(double left, double rate) {
    if (left < 0) return -kInfinity;
    return rate > 0 ? left / rate : kInfinity;
  }
};

double longest_two(const CorrectionGraph& graph, PointKind first, PointKind middle, PointKind last) {
  const ReducedLeg& one = graph.leg(first, middle);
  const ReducedLeg& two = graph.leg(middle, last);
  return TwoLegs{.most1 = one.reach_m(0),
                 .most2 = two.reach_m(0),
                 .rate1 = one.carries_on ? one.carried_rate : one.fresh_rate,
                 .rate2 = two.carried_rate,
                 .limit = two.carried_most}
      .longest();
}

}  // namespace

LegReach::LegReach(const CorrectionGraph& graph) {
  constexpr std::array kKinds{PointKind::vertical, PointKind::horizontal};
  for (const PointKind first : kKinds)
    for (const PointKind middle : kKinds) {
      one_m_ = std::max(one_m_, graph.leg(first, middle).reach_m(0));
      for (const PointKind last : kKinds) two_m_ = std::max(two_m_, longest_two(graph, first, middle, last));
    }
  two_m_ = std::min(two_m_ * (1 + kErrorSlack), 2 * one_m_);
}

double LegReach::farthest_m(int corrections) const {
  if (corrections <= 0) return 0;
  const double pairs = (corrections - corrections % 2) / 2.0;
  return corrections % 2 == 0 ? pairs * two_m_ : pairs * two_m_ + one_m_;
}

int LegReach::least_corrections(double distance_m) const {
  if (!(distance_m > 0) || two_m_ == kInfinity) return distance_m > 0 ? 1 : 0;
  int corrections = 2 * static_cast<int>(std::min(distance_m / two_m_, 1e8));
  while (farthest_m(corrections) < distance_m && corrections < 200'000'000) ++corrections;
  return corrections;
}

RemainingLength::RemainingLength(const CorrectionGraph& graph, double upper_m, RunContext& run)
    : graph_(&graph), upper_m_(upper_m), table_(graph.size(), search(run)) {}

double RemainingLength::at(Node node, double error) const {
  const double known = table_.at(node, error);
  if (known < kInfinity) return known * (1 - kRounding);
  if (upper_m_ == kInfinity) return kInfinity;
  const double longer = upper_m_ - graph_->from_start(node);
  return std::max(longer, graph_->to_goal(node)) * (1 - kRounding);
}

void RemainingLength::note_arrival(double length_m, int corrections) {
  if (length_m >= shortest_m_) return;
  shortest_m_ = length_m;
  shortest_corrections_ = corrections;
}

/// A* from the goal, with the straight line from the start as what is left.
std::vector<StepTable::Step> RemainingLength::search(RunContext& run) {
  const CorrectionGraph& graph = *graph_;
  std::vector<StepTable::Step> steps;
  std::vector<double> most_error(graph.size(), -1);
  // Of the last label put in the queue: spares many that it dominates.
  std::vector<double> open_error(graph.size(), -1);
  std::vector<double> open_length(graph.size(), 0);
  std::vector<Label> pool{{.error = kInfinity, .node = graph.goal()}};
  LabelQueue queue;
  queue.push(0, 0);
  while (!queue.empty()) {
    const Label at = pool[queue.pop().label];
    if (at.error <= most_error[at.node]) continue;
    if (labels_++ % kPollEvery == 0 && !run.keep_going()) {
      stopped_ = true;
      return {};
    }
    most_error[at.node] = at.error;
    if (at.node != graph.goal()) steps.push_back({at.node, at.length_m, at.error});
    if (at.node == graph.start()) {
      note_arrival(at.length_m, at.corrections);
      continue;
    }
    const int corrections = at.node == graph.goal() ? 0 : at.corrections + 1;
    graph.for_each_previous(at.node, at.error, [&](Node i, double d, double error) {
      if (error <= most_error[i]) return;
      const double length = at.length_m + d;
      const double key = length + graph.from_start(i);
      if (key * (1 - kRounding) > upper_m_ || (error <= open_error[i] && length >= open_length[i])) return;
      if (!graph.is_free(i, at.node)) return;
      open_error[i] = error;
      open_length[i] = length;
      queue.push(key, static_cast<std::uint32_t>(pool.size()));
      pool.push_back({.length_m = length, .error = error, .node = i, .corrections = corrections});
    });
  }
  return steps;
}

RemainingCorrections::RemainingCorrections(const CorrectionGraph& graph, int most, RunContext& run)
    : graph_(&graph), reach_(graph), most_(most), table_(graph.size(), sweep(run)) {}

RemainingCorrections::RemainingCorrections(const RemainingCorrections& whole, const CorrectionGraph& part)
    : graph_(&part), reach_(whole.reach_), most_(whole.most_), table_(whole.table_.part(part.whole())) {}

int RemainingCorrections::at(Node node, double error) const {
  const double known = table_.at(node, error);
  if (known < kInfinity) return static_cast<int>(known);
  return most_ + 1 - reach_.least_corrections(graph_->from_start(node));
}

/// Layer k holds the nodes whose most error grew when one more correction was allowed.
std::vector<StepTable::Step> RemainingCorrections::sweep(RunContext& run) {
  const CorrectionGraph& graph = *graph_;
  std::vector<StepTable::Step> steps;
  std::vector<double> most_error(graph.size(), -1);
  std::vector<double> next_error(graph.size(), -1);
  most_error[graph.goal()] = kInfinity;
  std::vector<Node> layer{graph.goal()};
  std::vector<Node> next;
  for (int left = 0; !layer.empty() && left <= most_; ++left) {
    const double farthest = reach_.farthest_m(most_ - left) * (1 + kRounding);
    for (const Node j : layer) {
      if (labels_++ % kPollEvery == 0 && !run.keep_going()) {
        stopped_ = true;
        return {};
      }
      graph.for_each_previous(j, most_error[j], [&](Node i, double, double error) {
        if (error <= most_error[i] || error <= next_error[i]) return;
        if (graph.from_start(i) > farthest || !graph.is_free(i, j)) return;
        if (next_error[i] < 0) next.push_back(i);
        next_error[i] = error;
      });
    }
    for (const Node i : next) {
      most_error[i] = std::exchange(next_error[i], -1);
      steps.push_back({i, static_cast<double>(left), most_error[i]});
    }
    layer.clear();
    std::ranges::copy_if(next, std::back_inserter(layer), [&](Node i) { return i != graph.start(); });
    next.clear();
  }
  return steps;
}

}  // namespace alate
