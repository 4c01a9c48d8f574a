#include "search/label_setting/shortest.hpp"

#include "search/label_setting/label_queue.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

class Search {
 public:
  Search(const CorrectionGraph& graph, const ShortestOptions& options)
      : graph_(graph), options_(options), least_error_(graph.size(), kInfinity), open_(graph.size()) {}

  ShortestResult run(RunContext& run) {
    add({.node = graph_.start()}, 0);
    while (!queue_.empty()) {
      const LabelQueue::Entry next = queue_.pop();
      const Label from = pool_[next.label];
      if (from.node == graph_.goal()) return arrived(next.label);
      if (from.error >= least_error_[from.node]) continue;
      if (result_.labels % kPollEvery == 0 && !run.keep_going()) {
        result_.stopped = true;
        result_.bound_m = next.key;
        return result_;
      }
      least_error_[from.node] = from.error;
      ++result_.labels;
      expand(next.label, from);
    }
    result_.bound_m = kInfinity;
    return result_;
  }

 private:
  ShortestResult arrived(std::uint32_t label) {
    result_.route = CorrectionRoute{pool_[label].length_m, points_to(graph_, pool_, label)};
    result_.bound_m = pool_[label].length_m;
    return result_;
  }

  void expand(std::uint32_t index, const Label& from) {
    const Node goal = graph_.goal();
    const double home = graph_.to_goal(from.node);
    if (graph_.leg(from.node, goal).keeps_limits(from.error, home) && graph_.is_free(from.node, goal))
      add({from.length_m + home, 0, goal, index, from.corrections}, cost(from) + home);
    graph_.for_each_next(from.node, from.error, [&](Node j, double d, double error) {
      if (error >= least_error_[j]) return;
      const double length = from.length_m + d;
      const double ahead = graph_.to_goal(j);
      if (length + ahead > options_.most_m) return;
      const Label next{length, error, j, index, from.corrections + 1};
      const double spent = cost(next);
      if (error >= open_[j].error && spent >= open_[j].cost) return;
      if (!graph_.is_free(from.node, j)) return;
      open_[j] = {error, spent};
      add(next, spent + options_.weight * ahead);
    });
  }

  double cost(const Label& label) const { return label.length_m + options_.correction_m * label.corrections; }

  void add(const Label& label, double key) {
    queue_.push(key, static_cast<std::uint32_t>(pool_.size()));
    pool_.push_back(label);
  }

  const CorrectionGraph& graph_;
  const ShortestOptions& options_;
  /// Of the label of a node that went into the queue last: spares many that it dominates.
  struct Open {
    double error = kInfinity;
    double cost = kInfinity;
  };
  std::vector<double> least_error_;
  std::vector<Open> open_;
  std::vector<Label> pool_;
  LabelQueue queue_;
  ShortestResult result_;
};

}  // namespace

ShortestResult shortest_route(const CorrectionGraph& graph, const ShortestOptions& options, RunContext& run) {
  return Search(graph, options).run(run);
}

}  // namespace alate
