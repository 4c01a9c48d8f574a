#include "ga/string_breeder.hpp"

#include <cmath>

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

/// The bare ends as a trip: every tail ends with it.
Trip ends_of(const CorrectionGraph& graph) { return fly(graph, {}); }

}  // namespace

/// One string on its way to the tail.
class StringBreeder::Growth {
 public:
  Growth(const StringBreeder& breeder, const Graft& graft, Stream& stream)
      : breeder_(breeder),
        graph_(breeder.graph_),
        graft_(graft),
        stream_(stream),
        temperature_m_(breeder.options_.temperature_m * std::pow(breeder.options_.spread, -stream.uniform())) {
    const auto kept = static_cast<std::ptrdiff_t>(graft.kept);
    nodes_.assign(graft.head.nodes.begin(), graft.head.nodes.begin() + 1 + kept);
    errors_.assign(graft.head.error.begin(), graft.head.error.begin() + 1 + kept);
  }

  std::optional<PointString> run(RunContext& run) {
    const StringBreederOptions& options = breeder_.options_;
    for (std::size_t steps = 0;; ++steps) {
      if (steps % kPollEvery == 0 && !run.keep_going()) return std::nullopt;
      if (grown() >= graft_.fresh)
        if (const auto joint = draw_joint()) return with_tail(*joint);
      if (nodes_.size() <= options.step_limit && step()) continue;
      if (grown() == 0 || dead_.size() >= options.step_backs) return std::nullopt;
      dead_.push_back(nodes_.back());
      nodes_.pop_back();
      errors_.pop_back();
    }
  }

 private:
  static constexpr std::size_t kPollEvery = 16;

  std::size_t grown() const { return nodes_.size() - 1 - graft_.kept; }

  /// One of the nodes of the tail that can be gone over to, nearer to the goal than here.
  std::optional<std::size_t> draw_joint() {
    joints_.clear();
    const Node here = nodes_.back();
    const Trip& tail = graft_.tail;
    for (std::size_t j = graft_.from; j < tail.nodes.size(); ++j) {
      const Node there = tail.nodes[j];
      if (there == here || breeder_.to_go_(there) >= breeder_.to_go_(here)) continue;
      const ReducedLeg& leg = graph_.leg(here, there);
      const double length = graph_.length(here, there);
      if (leg.keeps_limits(errors_.back(), length) && leg.after(errors_.back(), length) <= tail.room[j])
        joints_.push_back(j);
    }
    while (!joints_.empty()) {
      const std::size_t pick = stream_.below(joints_.size());
      if (graph_.is_free(here, tail.nodes[joints_[pick]])) return joints_[pick];
      joints_.erase(joints_.begin() + static_cast<std::ptrdiff_t>(pick));
    }
    return std::nullopt;
  }

  PointString with_tail(std::size_t joint) const {
    PointString points(nodes_.begin() + 1, nodes_.end());
    const auto& tail = graft_.tail.nodes;
    points.insert(points.end(), tail.begin() + static_cast<std::ptrdiff_t>(joint), tail.end() - 1);
    return points;
  }

  /// Goes on to a drawn point; false where there is none.
  bool step() {
    weigh();
    while (!open_.empty()) {
      const std::size_t pick = draw();
      const Successors::Arc arc = *open_[pick].arc;
      const Node here = nodes_.back();
      if (graph_.is_free(here, arc.to)) {
        errors_.push_back(graph_.leg(here, arc.to).after(errors_.back(), arc.length_m));
        nodes_.push_back(arc.to);
        return true;
      }
      open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(pick));
    }
    return false;
  }

  void weigh() {
    constexpr double kUnlikely = 30;  // e^-30
    open_.clear();
    double least = 0;
    for (const Successors::Arc& arc : breeder_.successors_.of(nodes_.back())) {
      const double estimate = arc.length_m + breeder_.to_go_(arc.to);
      if (!open_.empty() && estimate - least > kUnlikely * temperature_m_) break;
      if (arc.to == graph_.goal() || !graph_.leg(nodes_.back(), arc.to).keeps_limits(errors_.back(), arc.length_m))
        continue;
      if (std::ranges::find(nodes_, arc.to) != nodes_.end() || std::ranges::find(dead_, arc.to) != dead_.end())
        continue;
      if (open_.empty()) least = estimate;
      open_.push_back({&arc, std::exp((least - estimate) / temperature_m_)});
    }
  }

  std::size_t draw() {
    double sum = 0;
    for (const Weighed& one : open_) sum += one.weight;
    double left = stream_.uniform() * sum;
    for (std::size_t k = 0; k + 1 < open_.size(); ++k) {
      left -= open_[k].weight;
      if (left < 0) return k;
    }
    return open_.size() - 1;
  }

  struct Weighed {
    const Successors::Arc* arc = nullptr;
    double weight = 0;
  };

  const StringBreeder& breeder_;
  const CorrectionGraph& graph_;
  const Graft& graft_;
  Stream& stream_;
  double temperature_m_;
  std::vector<Node> nodes_;
  std::vector<double> errors_;
  std::vector<Node> dead_;
  std::vector<std::size_t> joints_;
  std::vector<Weighed> open_;
};

std::optional<PointString> StringBreeder::grow(const Graft& graft, Stream& stream, RunContext& run) const {
  return Growth(*this, graft, stream).run(run);
}

Individual StringBreeder::first(Stream& stream, RunContext& run) const {
  const Trip ends = ends_of(graph_);
  return born(grow({.head = ends, .tail = ends}, stream, run), stream.uniform() < options_.polish, run);
}

Individual StringBreeder::child(const Population& population, std::size_t /*slot*/, Stream& stream,
                                RunContext& run) const {
  const Individual& mother = parent(population, stream);
  if (!mother.feasible()) return first(stream, run);
  const bool crossed = stream.uniform() < options_.crossover;
  std::optional<PointString> genes;
  if (crossed) {
    const Individual& father = parent(population, stream);
    const Trip head = fly(graph_, mother.genes);
    const Trip tail = fly(graph_, father.genes);
    genes = grow({.head = head, .kept = stream.below(mother.genes.size() + 1), .tail = tail}, stream, run);
  }
  if (!crossed || (genes && stream.uniform() < options_.mutation))
    genes = changed(genes ? *genes : mother.genes, stream, run);
  return born(std::move(genes), stream.uniform() < options_.polish, run);
}

/// The best of a few drawn ones.
const Individual& StringBreeder::parent(const Population& population, Stream& stream) const {
  std::size_t best = population.size();
  for (std::size_t t = 0; t < options_.tournament; ++t) {
    const std::size_t drawn = stream.below(population.size());
    if (best == population.size() || population[drawn].cost < population[best].cost) best = drawn;
  }
  return population[best];
}

/// Mutation: a stretch of up to three points is drawn anew.
std::optional<PointString> StringBreeder::changed(const PointString& genes, Stream& stream, RunContext& run) const {
  constexpr std::size_t kMostLost = 3;
  const Trip trip = fly(graph_, genes);
  const std::size_t kept = stream.below(genes.size() + 1);
  const std::size_t from = std::min(trip.last(), kept + 1 + stream.below(kMostLost + 1));
  return grow({.head = trip, .kept = kept, .tail = trip, .from = from, .fresh = 1}, stream, run);
}

Individual StringBreeder::born(std::optional<PointString> genes, bool polished, RunContext& run) const {
  if (!genes) return {};
  if (polished) windows_.improve(*genes, run);
  const Trip trip = fly(graph_, *genes);
  if (!trip.keeps_limits) return {};  // `room` is exact but for rounding
  const double price = price_.of(trip.length_m, trip.corrections());
  return {.genes = std::move(*genes), .cost = price, .price = price};
}

void StringBreeder::survive(Population& population, Population& born) {
  const std::size_t size = population.size();
  Population all = std::move(population);
  all.insert(all.end(), born.begin(), born.end());
  std::ranges::stable_sort(all, {}, &Individual::cost);
  const auto twins = std::ranges::unique(all, [](const Individual& a, const Individual& b) {
    return a.feasible() && a.cost == b.cost && a.genes == b.genes;
  });
  all.erase(twins.begin(), twins.end());
  all.resize(size);
  population = std::move(all);
}

}  // namespace alate
