#include "search/label_setting/front.hpp"

#include <cmath>

#include "search/label_setting/layered_search.hpp"
#include "search/label_setting/shortest.hpp"

namespace alate {

namespace {

constexpr double kGoodWeight = 1.05;
/// A correction counts for more than any leg.
constexpr double kCorrection_m = 1e5;
constexpr double kFewWeight = 1.2;

struct FrontSearch {
  const CorrectionGraph& graph;
  RunContext& run;
  FrontResult result;
  std::optional<RemainingCorrections> corrections_left;  ///< On the whole graph.

  /// Something to start from. False if there is no route, or no time.
  bool find_any() {
    ShortestResult good = shortest_route(graph, {.weight = kGoodWeight}, run);
    result.labels += good.labels;
    result.stopped = good.stopped;
    result.best = std::move(good.route);
    result.bound_m = result.best || good.stopped ? graph.length(graph.start(), graph.goal()) : kInfinity;
    return result.best.has_value();
  }

  /// The shortest route with the fewest corrections.
  std::optional<CorrectionRoute> find_fewest() {
    if (result.best->points.empty()) return result.best;
    const double corrections_a_metre = 2 / LegReach(graph).farthest_m(2);
    const double weight = kFewWeight * (1 + kCorrection_m * corrections_a_metre);
    const ShortestResult few = shortest_route(graph, {.weight = weight, .correction_m = kCorrection_m}, run);
    result.labels += few.labels;
    if (!few.route) return stop();
    const CorrectionRoute& known = few.route->points.size() < result.best->points.size() ? *few.route : *result.best;
    const int most = static_cast<int>(known.points.size());
    const RemainingCorrections& left = corrections_left.emplace(graph, most, run);
    result.labels += left.labels();
    if (left.stopped()) return stop();
    for (int fewest = left.fewest(); fewest <= most; ++fewest) {
      const double cap = fewest == most ? known.length_m * (1 + kRounding) : kInfinity;
      LayeredSearch search(graph, {.corrections = left}, {.fewest = fewest, .most_m = {cap}});
      search.run(run);
      result.labels += search.labels();
      if (search.stopped()) return stop();
      if (search.length_m(0) < kInfinity) return search.route(0);
    }
    return known;
  }

  /// The rest, within the corridor of `fewest`.
  void fill_in(const CorrectionRoute& fewest) {
    if (fewest.points.empty()) return take_straight(fewest);
    const double upper = fewest.length_m * (1 + kRounding);
    const CorrectionGraph corridor = graph.within(upper);
    // The best route known leads the search for the shortest; beyond it a weaker bound will do.
    const RemainingLength length(corridor, std::min(fewest.length_m, result.best->length_m) * (1 + kRounding), run);
    result.labels += length.labels();
    if (length.stopped()) return void(stop());
    result.bound_m = length.shortest_m() * (1 - kRounding);
    LengthCaps known{.fewest = static_cast<int>(fewest.points.size())};
    const int most = std::max(known.fewest, length.shortest_corrections());
    known.most_m.assign(static_cast<std::size_t>(most - known.fewest) + 1, upper);
    const RemainingCorrections left = left_in(corridor, most);
    if (left.stopped()) return void(stop());
    for (const double power : {2.0, 1.0, 0.0}) {
      const LengthCaps caps = guess(known, length.shortest_m(), power);
      LayeredSearch search(corridor, {.corrections = left, .length = &length}, caps);
      search.run(run);
      result.labels += search.labels();
      if (search.stopped()) return void(stop());
      if (take(search, caps, known)) return;
    }
  }

  /// Caps that fall from the route with the fewest corrections to the shortest, but never above what is known.
  static LengthCaps guess(const LengthCaps& known, double shortest_m, double power) {
    LengthCaps caps = known;
    const double last = std::max(1.0, static_cast<double>(caps.most_m.size()) - 1);
    for (std::size_t i = 0; i < caps.most_m.size(); ++i) {
      const double share = std::pow(1 - static_cast<double>(i) / last, power);
      const double guessed = shortest_m + (known.most_m.front() - shortest_m) * share;
      caps.most_m[i] = std::min(caps.most_m[i], guessed * (1 + kRounding));
    }
    return caps;
  }

  /// Keeps what `search` found; true if all of it is proven.
  bool take(const LayeredSearch& search, const LengthCaps& caps, LengthCaps& known) {
    bool proven = true;
    result.routes.clear();
    for (std::size_t i = 0; i < caps.most_m.size(); ++i) {
      const double length = search.length_m(i);
      proven = proven && length <= caps.most_m[i];
      known.most_m[i] = std::min(known.most_m[i], length * (1 + kRounding));
      if (length < (i == 0 ? kInfinity : search.length_m(i - 1))) result.routes.push_back(search.route(i));
    }
    return proven;
  }

  /// For one more correction than was swept for, the bounds at hand will do.
  RemainingCorrections left_in(const CorrectionGraph& corridor, int most) {
    if (most <= corrections_left->most() + 1) return {*corrections_left, corridor};
    RemainingCorrections left(corridor, most, run);
    result.labels += left.labels();
    return left;
  }

  /// Nothing is shorter than the straight leg home.
  void take_straight(const CorrectionRoute& route) {
    result.routes = {route};
    result.bound_m = route.length_m;
  }

  std::optional<CorrectionRoute> stop() {
    result.stopped = true;
    result.routes.clear();
    return std::nullopt;
  }
};

}  // namespace

FrontResult correction_front(const CorrectionGraph& graph, RunContext& run) {
  FrontSearch search{graph, run, {}};
  if (search.find_any())
    if (const auto fewest = search.find_fewest()) search.fill_in(*fewest);
  if (!search.result.stopped) search.result.best.reset();
  return std::move(search.result);
}

FrontResult shortest_alone(const CorrectionGraph& graph, RunContext& run) {
  FrontSearch search{graph, run, {}};
  FrontResult& result = search.result;
  if (!search.find_any()) return std::move(result);
  const double upper = result.best->length_m * (1 + kRounding);
  ShortestResult proven = shortest_route(graph.within(upper), {.most_m = upper}, run);
  result.labels += proven.labels;
  result.stopped = proven.stopped;
  result.bound_m = proven.bound_m;
  if (proven.stopped) return std::move(result);
  result.routes = {*std::move(proven.route)};
  result.best.reset();
  return std::move(result);
}

}  // namespace alate
