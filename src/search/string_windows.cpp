#include "search/string_windows.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

/// Between nodes `from` and `to` of a trip, to be filled with at most `most_new` points.
struct Window {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t most_new = 0;
};

/// The cheapest filling of one window.
class Filling {
 public:
  Filling(const CorrectionGraph& graph, const Successors& successors, const RoutePrice& price)
      : graph_(graph), successors_(successors), price_(price) {}

  /// Finds a filling that is cheaper than what is there now by more than rounding.
  bool find(const Trip& trip, const Window& window) {
    const auto [from, to, most_new] = window;
    constexpr double kHair = 1e-9;
    double length = 0;
    for (std::size_t i = from + 1; i <= to; ++i) length += trip.leg_m[i];
    before_ = trip.nodes[from];
    after_ = trip.nodes[to];
    room_ = trip.room[to];
    least_ = price_.of(length, to - from - 1) * (1 - kHair);
    found_ = false;
    chain_.clear();
    extend(before_, trip.error[from], 0, most_new);
    return found_;
  }

  const PointString& best() const { return best_; }

 private:
  void extend(Node node, double error, double length_m, std::size_t left) {
    close(node, error, length_m);
    if (left == 0) return;
    for (const Successors::Arc& arc : successors_.of(node)) {
      if (arc.to == after_ || arc.to == before_ || arc.to == graph_.goal()) continue;
      const double length = length_m + arc.length_m;
      if (!(price_.of(length + graph_.length(arc.to, after_), chain_.size() + 1) < least_)) continue;
      const ReducedLeg& leg = graph_.leg(node, arc.to);
      if (!leg.keeps_limits(error, arc.length_m)) continue;
      chain_.push_back(arc.to);
      extend(arc.to, leg.after(error, arc.length_m), length, left - 1);
      chain_.pop_back();
    }
  }

  /// From the last point of the chain to the end of the window.
  void close(Node node, double error, double length_m) {
    if (node == after_) return;  // a string may come back to a point, but not from itself
    const double last = graph_.length(node, after_);
    const double price = price_.of(length_m + last, chain_.size());
    const ReducedLeg& leg = graph_.leg(node, after_);
    if (!(price < least_) || !leg.keeps_limits(error, last) || leg.after(error, last) > room_ || !is_free()) return;
    least_ = price;
    best_ = chain_;
    found_ = true;
  }

  bool is_free() const {
    Node node = before_;
    for (const Node ahead : chain_) {
      if (!graph_.is_free(node, ahead)) return false;
      node = ahead;
    }
    return graph_.is_free(node, after_);
  }

  const CorrectionGraph& graph_;
  const Successors& successors_;
  RoutePrice price_;
  Node before_ = 0;
  Node after_ = 0;
  double room_ = 0;
  double least_ = 0;
  bool found_ = false;
  PointString chain_;
  PointString best_;
};

/// A string under change, and its trip.
struct Improver {
  Filling filling;
  Trip trip;
  Trip trial;
  PointString changed;

  bool replace(const CorrectionGraph& graph, PointString& points, const Window& window) {
    if (!filling.find(trip, window)) return false;
    changed.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(window.from));
    changed.insert(changed.end(), filling.best().begin(), filling.best().end());
    changed.insert(changed.end(), points.begin() + static_cast<std::ptrdiff_t>(window.to) - 1, points.end());
    fly(graph, changed, trial);
    if (!trial.keeps_limits) return false;  // `room` is exact but for rounding
    std::swap(points, changed);
    std::swap(trip, trial);
    return true;
  }
};

}  // namespace

bool StringWindows::improve(PointString& points, RunContext& run) const {
  Improver improver{.filling = Filling(graph_, successors_, price_), .trip = fly(graph_, points)};
  bool any = false;
  for (bool changed = true; changed; any = any || changed) {
    changed = false;
    for (std::size_t from = 0; from < improver.trip.last(); ++from) {
      for (std::size_t lost = 0; lost <= options_.most_old && from + lost < improver.trip.last(); ++lost) {
        if (!run.keep_going()) return any || changed;
        if (improver.replace(graph_, points, {.from = from, .to = from + 1 + lost, .most_new = options_.most_new}))
          changed = true;
      }
    }
  }
  return any;
}

}  // namespace alate
