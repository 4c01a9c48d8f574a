#include "search/label_setting/chance_front.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "search/label_setting/chance_labels.hpp"
#include "search/label_setting/remaining.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

/// A complete route.
struct Arrival {
  double length_m = 0;
  int corrections = 0;
  double probability = 0;
  std::vector<CorrectionPoint> points;
};

/// Arrivals of which none is as good as another in all three.
class Archive {
 public:
  bool covers(double length_m, int corrections, double probability) const {
    return std::ranges::any_of(arrivals_, [&](const Arrival& one) {
      return one.length_m <= length_m && one.corrections <= corrections &&
             one.probability + kSameProbability >= probability;
    });
  }
  void add(Arrival arrival) {
    if (covers(arrival.length_m, arrival.corrections, arrival.probability)) return;
    std::erase_if(arrivals_, [&](const Arrival& one) {
      return arrival.length_m <= one.length_m && arrival.corrections <= one.corrections &&
             arrival.probability + kSameProbability >= one.probability;
    });
    arrivals_.push_back(std::move(arrival));
  }
  const std::vector<Arrival>& arrivals() const { return arrivals_; }
  double longest_certain_m() const {
    double longest = 0;
    for (const Arrival& one : arrivals_)
      if (one.probability + kSameProbability >= 1) longest = std::max(longest, one.length_m);
    return longest > 0 ? longest : kInfinity;
  }

 private:
  std::vector<Arrival> arrivals_;
};

class ChanceSearch {
 public:
  ChanceSearch(const CorrectionGraph& graph, const RemainingLength& length, const RemainingCorrections& corrections,
               Archive& archive)
      : graph_(graph), length_(length), corrections_(corrections), archive_(archive), labels_(graph.size()) {}

  /// `certain`: only routes that cannot fail. False if `run` ended it.
  bool run(bool certain, RunContext& run) {
    certain_ = certain;
    ChanceLabel start = labels_.fly(graph_.limits(), kNoLabel, {}, true);
    start.node = graph_.start();
    labels_.keep(start);
    std::vector<std::uint32_t> layer{0};
    std::vector<std::uint32_t> next;
    while (!layer.empty()) {
      for (const std::uint32_t index : layer) {
        if (labels_.is_dominated(index) || is_hopeless(labels_[index])) continue;
        if (expanded_++ % kPollEvery == 0 && !run.keep_going()) return false;
        expand(index, next);
      }
      layer.swap(next);
      next.clear();
    }
    return true;
  }
  std::uint64_t labels() const { return expanded_; }

 private:
  void expand(std::uint32_t index, std::vector<std::uint32_t>& next) {
    const ChanceLabel from = labels_[index];
    fly_home(index, from);
    graph_.for_each_next(from.node, labels_.least_error(from, graph_.kind(from.node)), [&](Node j, double d, double) {
      ChanceLabel label = labels_.fly(graph_.limits(), index,
                                      {.length_m = d, .kind = graph_.kind(j), .success = graph_.success(j)}, certain_);
      label.node = j;
      const bool useless = label.case_count == 0 || is_hopeless(label) || !graph_.is_free(from.node, j);
      if (useless)
        labels_.forget(label);
      else if (labels_.keep(label))
        next.push_back(labels_.size() - 1);
    });
  }

  void fly_home(std::uint32_t index, const ChanceLabel& from) {
    const double home = graph_.to_goal(from.node);
    if (!graph_.is_free(from.node, graph_.goal())) return;
    const ChanceLabel last = labels_.fly(graph_.limits(), index, {.length_m = home, .kind = PointKind::end}, certain_);
    labels_.forget(last);
    if (last.case_count == 0 || archive_.covers(last.length_m, from.corrections, last.probability)) return;
    archive_.add({last.length_m, from.corrections, std::min(1.0, last.probability), labels_.points_to(graph_, index)});
  }

  /// Is some known route as good as whatever may become of it? In the best case all its corrections worked, and no case
  /// is lost any more.
  bool is_hopeless(const ChanceLabel& label) const {
    const double error = labels_.least_error(label, graph_.kind(label.node));
    const int corrections = label.corrections + corrections_.at(label.node, error);
    const double length = label.length_m + length_.at(label.node, error);
    return length == kInfinity || archive_.covers(length, corrections, label.probability);
  }

  const CorrectionGraph& graph_;
  const RemainingLength& length_;
  const RemainingCorrections& corrections_;
  Archive& archive_;
  ChanceLabels labels_;
  bool certain_ = false;
  std::uint64_t expanded_ = 0;
};

/// Routes whose points never fail.
void add_reliable(const CorrectionGraph& graph, Archive& archive, FrontResult& result, RunContext& run) {
  const FrontResult reliable = correction_front(graph.reliable(), run);
  result.labels += reliable.labels;
  result.stopped = reliable.stopped;
  for (const CorrectionRoute& route : reliable.routes)
    archive.add({route.length_m, static_cast<int>(route.points.size()), 1, route.points});
}

void add_nominal(const CorrectionGraph& graph, const FrontResult& nominal, Archive& archive) {
  const Vec3 start = graph.position(graph.start());
  const Vec3 goal = graph.position(graph.goal());
  for (const CorrectionRoute& route : nominal.routes)
    archive.add({route.length_m, static_cast<int>(route.points.size()),
                 success_probability(graph.limits(), start, goal, route.points), route.points});
}

std::vector<CorrectionRoute> routes_of(const Archive& archive) {
  std::vector<Arrival> arrivals = archive.arrivals();
  std::ranges::sort(arrivals, [](const Arrival& a, const Arrival& b) {
    return std::tie(a.corrections, a.length_m) < std::tie(b.corrections, b.length_m);
  });
  std::vector<CorrectionRoute> routes;
  for (Arrival& one : arrivals) routes.push_back({one.length_m, std::move(one.points)});
  return routes;
}

}  // namespace

FrontResult chance_front(const CorrectionGraph& graph, RunContext& run) {
  FrontResult result = correction_front(graph, run);
  if (result.stopped || result.routes.empty()) return result;
  Archive archive;
  result.best = result.routes.back();
  add_nominal(graph, result, archive);
  add_reliable(graph, archive, result, run);
  const RemainingLength length(graph, archive.longest_certain_m() * (1 + kRounding), run);
  const RemainingCorrections corrections(graph, static_cast<int>(graph.size()), run);
  result.stopped = result.stopped || length.stopped() || corrections.stopped();
  for (const bool certain : {true, false}) {
    if (result.stopped) break;
    ChanceSearch search(graph, length, corrections, archive);
    result.stopped = !search.run(certain, run);
    result.labels += search.labels();
  }
  result.routes = result.stopped ? std::vector<CorrectionRoute>{} : routes_of(archive);
  if (!result.stopped) result.best.reset();
  return result;
}

}  // namespace alate
