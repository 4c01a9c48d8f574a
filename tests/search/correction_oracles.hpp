// Slow and plain solvers of problems 1 and 3, for small sets of points.
#pragma once

#include <gtest/gtest.h>

#include "search/label_setting/front.hpp"
#include "space/error_cases.hpp"
#include "support/correction_sites.hpp"
#include "support/front_value.hpp"

namespace alate::test {

/// Points in a box that takes some corrections to cross, limits of set 1.
inline CorrectionField small_field(int points, double width_m, std::uint64_t seed) {
  CorrectionField field = draw_corrections(CorrectionLaw::set1, points, seed);
  const double scale = width_m / field.goal.x();
  for (Vec3* at : {&field.start, &field.goal}) at->head<2>() *= scale;
  for (CorrectionPoint& point : field.navigation.points) {
    point.position.x() *= scale;
    point.position.y() = field.start.y() + 0.6 * (point.position.y() * scale - field.start.y());
    point.success = point.id % 3 == 0 ? 0.8 : point.id % 7 == 0 ? 0.5 : 1.0;
  }
  return field;
}

/// Every walk of up to `most` corrections, nominal limits kept. visit(length, indices of points).
template <class Visit>
void for_each_walk(const CorrectionField& field, std::size_t most, Visit&& visit) {
  const Navigation& navigation = field.navigation;
  std::vector<std::size_t> walk;
  const auto extend = [&](const auto& self, const Vec3& at, const NavigationError& error, double length) -> void {
    const double home = (field.goal - at).norm();
    if (arrive(navigation, error, home, PointKind::end)) visit(length + home, walk);
    if (walk.size() == most) return;
    for (std::size_t j = 0; j < navigation.points.size(); ++j) {
      if (!walk.empty() && walk.back() == j) continue;
      const double d = (navigation.points[j].position - at).norm();
      const auto after = arrive(navigation, error, d, navigation.points[j].kind);
      if (!after) continue;
      walk.push_back(j);
      self(self, navigation.points[j].position, *after, length + d);
      walk.pop_back();
    }
  };
  extend(extend, field.start, {}, 0);
}

/// The front of all walks of up to `most` corrections.
inline std::vector<FrontValue> brute_force_front(const CorrectionField& field, std::size_t most, bool chances) {
  std::vector<FrontValue> values;
  for_each_walk(field, most, [&](double length, const std::vector<std::size_t>& walk) {
    FrontValue value{static_cast<int>(walk.size()), length, 1};
    std::vector<CorrectionPoint> points;
    for (const std::size_t j : walk) points.push_back(field.navigation.points[j]);
    if (chances) value.probability = success_probability(field.navigation, field.start, field.goal, points);
    if (std::ranges::any_of(values, [&](const FrontValue& one) { return one.is_as_good_as(value); })) return;
    values.push_back(value);
  });
  return front_of(std::move(values));
}

/// Length left, and the most error with which it can be flown.
struct WayLeft {
  double length = 0;
  double most_error = 0;
};
using WaysLeft = std::vector<std::vector<WayLeft>>;  ///< By node.

inline bool is_dominated(const WayLeft& way, const std::vector<WayLeft>& ways) {
  return std::ranges::any_of(
      ways, [&](const WayLeft& one) { return one.length <= way.length && one.most_error >= way.most_error; });
}

/// Where a way begins, and how it goes on.
struct WayFrom {
  CorrectionGraph::Node node = 0;
  WayLeft left;
};

/// All ways that are one leg longer than `way` and not known to be dominated.
inline void append_longer(const CorrectionGraph& graph, const WayFrom& way, const WaysLeft& known, WaysLeft& next) {
  for (CorrectionGraph::Node i = 0; i < graph.goal(); ++i) {
    if (i == way.node) continue;
    const double d = graph.length(i, way.node);
    const WayLeft longer{way.left.length + d, graph.leg(i, way.node).most_before(way.left.most_error, d)};
    if (longer.most_error < 0 || is_dominated(longer, known[i]) || is_dominated(longer, next[i])) continue;
    next[i].push_back(longer);
  }
}

/// Backward dynamic programming over layers of corrections left, nothing pruned but what is dominated.
inline std::vector<FrontValue> backward_front(const CorrectionField& field) {
  const CorrectionGraph graph(field.navigation, field.start, field.goal);
  WaysLeft known(graph.size());
  WaysLeft layer(graph.size());
  std::vector<FrontValue> values;
  layer[graph.goal()] = {{0, 1e300}};
  for (int left = 0; std::ranges::any_of(layer, [](const auto& ways) { return !ways.empty(); }); ++left) {
    WaysLeft next(graph.size());
    for (CorrectionGraph::Node j = 0; j < graph.size(); ++j)
      for (const WayLeft& way : layer[j]) append_longer(graph, {j, way}, known, next);
    for (const WayLeft& way : next[graph.start()]) values.push_back({left, way.length, 1});
    for (std::size_t i = 0; i < next.size(); ++i) known[i].insert(known[i].end(), next[i].begin(), next[i].end());
    next[graph.start()].clear();
    layer.swap(next);
  }
  return front_of(std::move(values));
}

inline std::vector<FrontValue> values_of(const CorrectionField& field, const FrontResult& front) {
  std::vector<FrontValue> values;
  for (const CorrectionRoute& route : front.routes)
    values.push_back({static_cast<int>(route.points.size()), route.length_m,
                      success_probability(field.navigation, field.start, field.goal, route.points)});
  return values;
}

inline void expect_same_front(const std::vector<FrontValue>& ours, const std::vector<FrontValue>& theirs,
                              const std::string& name) {
  ASSERT_EQ(ours.size(), theirs.size()) << name;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_EQ(ours[i].corrections, theirs[i].corrections) << name;
    EXPECT_NEAR(ours[i].length_m, theirs[i].length_m, 1e-6) << name;
    EXPECT_NEAR(ours[i].probability, theirs[i].probability, 1e-10) << name;
  }
}

}  // namespace alate::test
