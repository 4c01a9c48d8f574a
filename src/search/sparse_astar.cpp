#include "search/sparse_astar.hpp"

#include <limits>

#include "search/label_setting/label_queue.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// One way to a node.
struct Way {
  Node node = 0;
  std::uint32_t parent = kNone;
  double length_m = 0;
  double error = 0;
  double g = 0;
};

/// Published bookkeeping: one g a node.
class NodeLists {
 public:
  explicit NodeLists(std::size_t nodes)
      : least_(nodes, std::numeric_limits<double>::infinity()), closed_(nodes, false) {}

  bool takes(const Way& way) const { return !closed_[way.node] && way.g < least_[way.node]; }
  void open(const Way& way) { least_[way.node] = way.g; }
  /// False if a better way to the node was expanded.
  bool close(const Way& way) {
    if (closed_[way.node]) return false;
    closed_[way.node] = true;
    return true;
  }

 private:
  std::vector<double> least_;
  std::vector<bool> closed_;
};

/// Corrected bookkeeping: the expanded ways to each node.
class LabelLists {
 public:
  explicit LabelLists(std::size_t nodes) : expanded_(nodes) {}

  bool takes(const Way& way) const {
    return std::ranges::none_of(expanded_[way.node], [&](const Label& label) {
      return label.length_m <= way.length_m && label.error <= way.error;
    });
  }
  void open(const Way& /*way*/) {}
  bool close(const Way& way) {
    if (!takes(way)) return false;
    auto& labels = expanded_[way.node];
    std::erase_if(labels,
                  [&](const Label& label) { return label.length_m >= way.length_m && label.error >= way.error; });
    labels.push_back({way.length_m, way.error});
    return true;
  }

 private:
  struct Label {
    double length_m = 0;
    double error = 0;
  };
  std::vector<std::vector<Label>> expanded_;
};

template <class Lists>
class Search {
 public:
  Search(const CorrectionGraph& graph, const SparseAstarOptions& options)
      : graph_(graph), options_(options), lists_(graph.size()) {}

  SparseAstarResult run(RunContext& run) {
    push({.node = graph_.start()});
    constexpr std::uint64_t kPollEvery = 1024;
    while (!queue_.empty()) {
      if (result_.expansions % kPollEvery == 0 && !run.keep_going()) return std::move(result_);
      const std::uint32_t at = queue_.pop().label;
      const Way way = ways_[at];
      if (!lists_.close(way)) continue;
      if (way.node == graph_.goal()) return arrived(at);
      ++result_.expansions;
      expand(at, way);
    }
    result_.exhausted = options_.keep_errors;
    return std::move(result_);
  }

 private:
  double left_m(Node node) const { return graph_.to_goal(node); }

  void push(Way way) {
    if (!lists_.takes(way)) return;
    lists_.open(way);
    ways_.push_back(way);
    queue_.push(way.g + options_.q3 * left_m(way.node), static_cast<std::uint32_t>(ways_.size() - 1));
  }

  void expand(std::uint32_t at, const Way& way) {
    const auto go_on = [&](Node to, double length_m, double error) {
      ++result_.candidates;
      const Way ahead{.node = to,
                      .parent = at,
                      .length_m = way.length_m + length_m,
                      .error = error,
                      .g = way.g + (options_.q1 + options_.q2 * drift(graph_.kind(to))) * length_m};
      if (lists_.takes(ahead) && graph_.is_free(way.node, to)) push(ahead);
    };
    graph_.for_each_next(way.node, way.error, go_on);
    const double home = left_m(way.node);
    if (graph_.leg(way.node, graph_.goal()).keeps_limits(way.error, home)) go_on(graph_.goal(), home, 0);
  }

  double drift(PointKind kind) const {
    const Navigation& navigation = graph_.limits();
    if (kind == PointKind::vertical) return navigation.drift_vertical;
    if (kind == PointKind::horizontal) return navigation.drift_horizontal;
    return (navigation.drift_vertical + navigation.drift_horizontal) / 2;
  }

  SparseAstarResult arrived(std::uint32_t goal) {
    result_.found = true;
    for (std::uint32_t at = ways_[goal].parent; ways_[at].parent != kNone; at = ways_[at].parent)
      result_.points.push_back(ways_[at].node);
    std::ranges::reverse(result_.points);
    if (options_.keep_errors) result_.bound_m = bound_m(ways_[goal].length_m);
    return std::move(result_);
  }

  /// The shortest route is this one, or goes on from one of the open ways.
  double bound_m(double found_m) {
    double bound = found_m;
    while (!queue_.empty()) {
      const Way& way = ways_[queue_.pop().label];
      if (lists_.takes(way)) bound = std::min(bound, way.length_m + left_m(way.node));
    }
    return bound;
  }

  const CorrectionGraph& graph_;
  SparseAstarOptions options_;
  Lists lists_;
  std::vector<Way> ways_;
  LabelQueue queue_;
  SparseAstarResult result_;
};

}  // namespace

SparseAstarResult sparse_astar(const CorrectionGraph& graph, const SparseAstarOptions& options, RunContext& run) {
  if (options.keep_errors) return Search<LabelLists>(graph, options).run(run);
  return Search<NodeLists>(graph, options).run(run);
}

}  // namespace alate
