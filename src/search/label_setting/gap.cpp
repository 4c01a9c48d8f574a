#include "search/label_setting/gap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "search/label_setting/label.hpp"
#include "search/label_setting/remaining.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

/// Least error with which each node can be reached; infinite where it cannot be.
std::vector<double> flood(const CorrectionGraph& graph) {
  std::vector<double> least(graph.size(), kInfinity);
  std::vector<Node> open{graph.start()};
  least[graph.start()] = 0;
  while (!open.empty()) {
    const Node i = open.back();
    open.pop_back();
    graph.for_each_next(i, least[i], [&](Node j, double, double error) {
      if (error >= least[j] || !graph.is_free(i, j)) return;
      least[j] = error;
      open.push_back(j);
    });
  }
  return least;
}

struct Gap {
  Node from = 0;
  Node to = 0;
  double wanting_m = kInfinity;  ///< Negative: near enough, but closed by something else.
};

class GapSearch {
 public:
  GapSearch(const CorrectionGraph& graph, RunContext& run)
      : graph_(graph), least_(flood(graph)), onward_(graph, static_cast<int>(graph.size()), run) {}

  Gap run(RunContext& run) {
    for (Node i = 0; i <= graph_.start(); ++i)
      if (least_[i] < kInfinity) try_leg(i, graph_.goal());
    for (Node i = 0; i <= graph_.start() && run.keep_going(); ++i)
      if (least_[i] < kInfinity) try_neighbours(i);
    return gap_;
  }

  double error_at(Node i) const { return least_[i]; }
  /// Points that can be reached.
  std::ptrdiff_t reached() const {
    return std::ranges::count_if(least_, [](double error) { return error < kInfinity; }) - 1;
  }

 private:
  void try_leg(Node i, Node j) {
    const double wanting = graph_.length(i, j) - graph_.leg(i, j).reach_m(least_[i]);
    if (wanting < gap_.wanting_m) gap_ = {i, j, wanting};
  }

  void try_neighbours(Node i) {
    for (const PointKind kind : {PointKind::vertical, PointKind::horizontal}) {
      const double reach = graph_.leg(graph_.kind(i), kind).reach_m(least_[i]);
      graph_.near(i, kind, reach + gap_.wanting_m, [&](Node first, Node last) {
        for (Node j = first; j < last; ++j)
          if (least_[j] == kInfinity && leads_on(j)) try_leg(i, j);
      });
    }
  }

  bool leads_on(Node j) const { return onward_.at(j, 0) <= static_cast<int>(graph_.size()); }

  const CorrectionGraph& graph_;
  std::vector<double> least_;
  RemainingCorrections onward_;
  Gap gap_;
};

std::string name_of(const CorrectionGraph& graph, Node i) {
  if (i == graph.start()) return "the start";
  const Vec3 at = graph.position(i);
  const std::string place = fmt::format("(x {:.0f} m, y {:.0f} m)", at.x(), at.y());
  return i == graph.goal() ? "the goal " + place : fmt::format("point {} {}", graph.id(i), place);
}

/// "vertical error at most 20 at a horizontal point".
std::string limit_of(const CorrectionGraph& graph, const Gap& gap, double error) {
  const ReducedLeg& leg = graph.leg(gap.from, gap.to);
  const PointKind to = graph.kind(gap.to);
  if (to == PointKind::end) return fmt::format("both errors below {:g} at the goal", graph.limits().theta);
  const bool fresh = leg.fresh_most * leg.carried_rate <= (leg.carried_most - error) * leg.fresh_rate;
  const bool vertical = fresh == (graph.kind(gap.from) == PointKind::vertical);
  return fmt::format("{} error at most {:g} at a {} point", vertical ? "vertical" : "horizontal",
                     fresh ? leg.fresh_most : leg.carried_most, to == PointKind::vertical ? "vertical" : "horizontal");
}

}  // namespace

std::string describe_gap(const CorrectionGraph& graph, RunContext& run) {
  GapSearch search(graph, run);
  const Gap gap = search.run(run);
  const double error = search.error_at(gap.from);
  const std::string head = fmt::format(
      "{} of {} correction points can be reached from the start. The leg that is wanting least, "
      "from {} to {}, ",
      search.reached(), graph.point_count(), name_of(graph, gap.from), name_of(graph, gap.to));
  if (gap.wanting_m <= 0)
    return head +
           "keeps the error limits, but ground, a ceiling, a threat's core or a climb limit closes it, or the "
           "errors grow too large behind it";
  return head + fmt::format("is {:.0f} m long; the errors allow {:.0f} m ({}, {:.1f} already carried)",
                            graph.length(gap.from, gap.to), std::max(0.0, graph.leg(gap.from, gap.to).reach_m(error)),
                            limit_of(graph, gap, error), error);
}

}  // namespace alate
