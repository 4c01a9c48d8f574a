#include "search/turning/turning_front.hpp"

#include <algorithm>
#include <array>

#include "search/turning/turning_search.hpp"

namespace alate {

namespace {

using Node = CorrectionGraph::Node;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lengths of ellipsoids, in straight lines from start to goal.
constexpr std::array kWidths{1.05, 1.1, 1.2, 1.4, 2.0, kInfinity};
constexpr double kWithin = 1 - 1e-9;  ///< So much of a corridor surely holds all its routes, whatever rounding does.
constexpr double kLongest = 4;        ///< Of a route, in shortest straight routes.
constexpr double kRounding = 1e-12;

/// The part of the graph where routes up to `upper_m` lie, with the lengths left in it.
struct Corridor {
  Corridor(const CorrectionGraph& whole, double most_m, RunContext& run)
      : upper_m(most_m), graph(whole.within(most_m)), length(graph, most_m, run) {}

  double upper_m;
  CorrectionGraph graph;
  RemainingLength length;
};

class FrontSearch {
 public:
  FrontSearch(const CorrectionGraph& graph, const TurnRule& rule, RunContext& run)
      : whole_(graph), rule_(rule), run_(run), direct_m_(graph.length(graph.start(), graph.goal())) {}

  FrontResult find(bool shortest_alone) {
    front_.bound_m = direct_m_;
    front_.proven = rule_.model != TurnModel::free_heading;
    std::optional<int> most;
    while (find_next(most) && !shortest_alone) {
      most = static_cast<int>(front_.routes.back().points.size()) - 1;
      if (*most < 0) break;
    }
    if (front_.stopped && !front_.routes.empty()) {
      front_.best = std::move(front_.routes.front());
      front_.routes.clear();
    }
    std::ranges::reverse(front_.routes);
    return std::move(front_);
  }

 private:
  /// The shortest route with up to `most` corrections. False if there is none, or the search was stopped.
  bool find_next(std::optional<int> most) {
    for (; width_ < kWidths.size(); ++width_) {
      if (!corridor_) corridor_.emplace(whole_, kWidths.at(width_) * direct_m_, run_);
      if (corridor_->length.stopped()) return stop();
      const TurningResult result = search(most);
      front_.labels += result.expansions;
      if (!most) keep_bound(result);
      if (!result.nodes.empty()) {
        keep(result);
        return result.exhausted || stop();
      }
      if (!result.exhausted) return stop();
      if (width_ + 1 == kWidths.size()) return result.cut && stop();
      corridor_.reset();
    }
    return false;
  }

  TurningResult search(std::optional<int> most) {
    const double shortest = corridor_->length.shortest_m();
    TurningQuery query{.length = corridor_->length, .most_corrections = most, .heading = rule_.heading};
    query.shorter_than_m = std::min(corridor_->upper_m * kWithin, kLongest * shortest);
    if (rule_.model == TurnModel::free_heading)
      query.flown_m = [this](TurningQuery::Nodes nodes) { return flown_m(nodes); };
    std::optional<RemainingCorrections> corrections;
    if (most) {
      corrections.emplace(corridor_->graph, *most, run_);
      if (corrections->stopped()) return {.exhausted = false};
      query.corrections = &*corrections;
    }
    return shortest_turning_route(corridor_->graph, query, run_);
  }

  /// What the first search says of all routes; beyond the corridor none is shorter than the corridor is long.
  void keep_bound(const TurningResult& result) {
    const bool free = rule_.model == TurnModel::free_heading;
    const double bound = free ? corridor_->length.shortest_m() * (1 - kRounding) : result.bound_m;
    front_.bound_m = std::max(front_.bound_m, std::min(bound, corridor_->upper_m * kWithin));
  }

  std::vector<Vec3> positions(TurningQuery::Nodes nodes) const {
    std::vector<Vec3> result;
    for (const Node node : nodes) result.push_back(corridor_->graph.position(node));
    return result;
  }

  double flown_m(TurningQuery::Nodes nodes) const {
    const TurningFlight flight = fly_over(positions(nodes), rule_);
    if (flight.legs.size() + 1 < nodes.size()) return kInfinity;
    double error = 0;
    for (std::size_t i = 0; i < flight.legs.size(); ++i) {
      const ReducedLeg& leg = corridor_->graph.leg(nodes[i], nodes[i + 1]);
      if (!leg.keeps_limits(error, flight.legs[i].length_m)) return kInfinity;
      error = leg.after(error, flight.legs[i].length_m);
    }
    return flight.length_m;
  }

  void keep(const TurningResult& result) {
    CorrectionRoute route{.length_m = result.length_m, .points = {}};
    for (std::size_t i = 1; i + 1 < result.nodes.size(); ++i)
      route.points.push_back(corridor_->graph.point(result.nodes[i]));
    front_.routes.push_back(std::move(route));
  }

  bool stop() {
    front_.stopped = true;
    return false;
  }

  const CorrectionGraph& whole_;
  const TurnRule& rule_;
  RunContext& run_;
  double direct_m_;
  std::size_t width_ = 0;
  std::optional<Corridor> corridor_;
  FrontResult front_;
};

}  // namespace

FrontResult turning_front(const CorrectionGraph& graph, const TurnRule& rule, bool shortest_alone, RunContext& run) {
  return FrontSearch(graph, rule, run).find(shortest_alone);
}

}  // namespace alate
