#include "search/turning/turning_search.hpp"

#include <algorithm>
#include <tuple>

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Where a partial route ends.
struct Branch {
  double bound_m;  ///< No route that begins so is shorter.
  double length_m;
  double error;
  Pose pose;
  Node node;
  std::uint32_t depth;  ///< Legs flown.
};

class TurningSearch {
 public:
  TurningSearch(const CorrectionGraph& graph, const TurningQuery& query)
      : graph_(graph), query_(query), radius_m_(graph.limits().turn_radius_m) {
    result_.length_m = query.shorter_than_m;
  }

  TurningResult run(RunContext& run) {
    push_start();
    while (!open_.empty()) {
      const Branch branch = open_.back();
      if (branch.bound_m < result_.length_m && !may_go_on(run)) return finish(false);
      open_.pop_back();
      if (branch.bound_m >= result_.length_m) continue;
      ++result_.expansions;
      way_.resize(branch.depth + 1);
      way_[branch.depth] = branch.node;
      if (branch.node == graph_.goal()) {
        arrive(branch);
      } else {
        expand(branch);
      }
    }
    return finish(true);
  }

 private:
  bool may_go_on(RunContext& run) const {
    constexpr std::uint64_t kMostExpansions = 100'000'000;
    constexpr std::uint64_t kMostFlights = 100'000;
    constexpr std::uint64_t kPoll = 1024;
    if (result_.expansions >= kMostExpansions || flights_ >= kMostFlights) return false;
    return result_.expansions % kPoll != 0 || run.keep_going();
  }

  void push_start() {
    const Node start = graph_.start();
    Branch root{.bound_m = 0,
                .length_m = 0,
                .error = 0,
                .pose = {graph_.position(start), query_.heading.value_or(Vec3::Zero())},
                .node = start,
                .depth = 0};
    root.bound_m = rest_m(start, 0, 0);
    if (promises(root.bound_m)) open_.push_back(root);
  }

  void arrive(const Branch& branch) {
    const double length = query_.flown_m ? query_.flown_m(way_) : branch.length_m;
    ++flights_;
    if (length >= result_.length_m) return;
    result_.length_m = length;
    result_.nodes = way_;
  }

  /// Adds all next branches that may be part of a shorter route, the most promising last.
  void expand(const Branch& branch) {
    const std::size_t first = open_.size();
    graph_.for_each_next(branch.node, branch.error, [&](Node j, double d, double) { add(branch, j, d); });
    add(branch, graph_.goal(), graph_.to_goal(branch.node));
    std::ranges::sort(
        open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end(),
        [](const Branch& a, const Branch& b) { return std::tie(a.bound_m, a.node) > std::tie(b.bound_m, b.node); });
  }

  /// `distance_m` straight to `j`: what cannot be better on a straight leg need not be turned to.
  void add(const Branch& branch, Node j, double distance_m) {
    if (!promises(bound_if(branch, j, distance_m))) return;
    const Vec3 to = graph_.position(j);
    const bool straight = query_.flown_m || (branch.depth == 0 && !query_.heading);
    const auto leg = straight ? straight_leg(branch.pose.position, to) : arc_tangent_leg(branch.pose, to, radius_m_);
    if (!leg) return;
    const double bound = bound_if(branch, j, leg->length_m);
    if (!promises(bound)) return;
    open_.push_back({.bound_m = bound,
                     .length_m = branch.length_m + leg->length_m,
                     .error = graph_.leg(branch.node, j).after(branch.error, leg->length_m),
                     .pose = {to, leg->heading},
                     .node = j,
                     .depth = branch.depth + 1});
  }

  /// Least length of a route whose next leg leads to `j`; infinite if that breaks a limit.
  double bound_if(const Branch& branch, Node j, double leg_m) const {
    const ReducedLeg& leg = graph_.leg(branch.node, j);
    if (!leg.keeps_limits(branch.error, leg_m)) return kNone;
    return branch.length_m + leg_m + rest_m(j, leg.after(branch.error, leg_m), branch.depth + 1);
  }

  /// Least length after `node`, the end of the `depth`-th leg; infinite if it takes too many corrections.
  double rest_m(Node node, double error, std::uint32_t depth) const {
    if (node == graph_.goal()) return 0;
    if (query_.most_corrections &&
        static_cast<int>(depth) + query_.corrections->at(node, error) > *query_.most_corrections)
      return kNone;
    return query_.length.at(node, error);
  }

  bool promises(double bound_m) {
    if (bound_m < result_.length_m) return true;
    result_.cut = result_.cut || (bound_m < kNone && result_.nodes.empty());
    return false;
  }

  TurningResult finish(bool exhausted) {
    result_.exhausted = exhausted;
    if (result_.nodes.empty()) result_.length_m = kNone;
    result_.bound_m = result_.length_m;
    for (const Branch& branch : open_) result_.bound_m = std::min(result_.bound_m, branch.bound_m);
    return std::move(result_);
  }

  const CorrectionGraph& graph_;
  const TurningQuery& query_;
  double radius_m_;
  std::uint64_t flights_ = 0;  ///< Whole routes looked at.
  std::vector<Branch> open_;   ///< A stack; the deepest on top.
  std::vector<Node> way_;      ///< To the branch in hand.
  TurningResult result_;
};

}  // namespace

TurningResult shortest_turning_route(const CorrectionGraph& graph, const TurningQuery& query, RunContext& run) {
  return TurningSearch(graph, query).run(run);
}

}  // namespace alate
