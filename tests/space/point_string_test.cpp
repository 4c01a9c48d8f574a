// Strings of correction points, the relaxed way to the goal and the lists of successors.
#include "space/point_string.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "alate/core/stream.hpp"
#include "data/correction_law.hpp"
#include "space/candidates.hpp"
#include "space/successors.hpp"

namespace alate {
namespace {

using Node = CorrectionGraph::Node;

CorrectionGraph graph_of(const CorrectionField& field) { return {field.navigation, field.start, field.goal}; }

/// The same by both errors, leg by leg.
bool replay(const CorrectionGraph& graph, const PointString& points) {
  NavigationError error;
  Node at = graph.start();
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const Node to = i < points.size() ? points[i] : graph.goal();
    const auto after = arrive(graph.limits(), error, graph.length(at, to), graph.kind(to));
    if (!after) return false;
    error = *after;
    at = to;
  }
  return true;
}

/// Some random points in the order of x.
PointString random_string(const CorrectionGraph& graph, std::size_t count, Stream& stream) {
  PointString points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(static_cast<Node>(stream.below(graph.point_count())));
  std::ranges::sort(points, {}, [&](Node i) { return graph.position(i).x(); });
  points.erase(std::ranges::unique(points).begin(), points.end());
  return points;
}

TEST(PointString, TripsAgreeWithBothErrorsAndLeaveExactlyTheRoomThereIs) {
  CorrectionField field = draw_corrections(CorrectionLaw::set1, 60, 2);
  field.navigation.drift_horizontal = 0.0012;
  const CorrectionGraph graph = graph_of(field);
  int kept = 0;
  constexpr int kTrials = 20'000;
  for (int trial = 0; trial < kTrials; ++trial) {
    Stream stream(3, 0, static_cast<std::uint64_t>(trial));
    const PointString points = random_string(graph, stream.below(8), stream);
    const Trip trip = fly(graph, points);
    ASSERT_EQ(trip.keeps_limits, replay(graph, points));
    if (std::abs(trip.room[0]) > 1e-9) {
      ASSERT_EQ(trip.keeps_limits, trip.room[0] >= 0);
    }
    if (!trip.keeps_limits) continue;
    ++kept;
    for (std::size_t i = 0; i <= trip.last(); ++i) EXPECT_LE(trip.error[i], trip.room[i] + 1e-9);
    EXPECT_NEAR(trip.length_m, std::accumulate(trip.leg_m.begin(), trip.leg_m.end(), 0.0), 1e-6);
  }
  EXPECT_GT(kept, 50);
  EXPECT_LT(kept, kTrials / 2);
}

class RelaxedWay : public testing::Test {
 protected:
  Executor executor_{2};
  RunContext run_{executor_, {}};
};

TEST_F(RelaxedWay, IsTheShortestOverLegsThatCanBeFlownWithoutError) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CorrectionGraph graph = graph_of(draw_corrections(CorrectionLaw::set2, 120, seed));
    std::vector<double> expected(graph.size(), kInfinity);
    expected[graph.goal()] = 0;
    for (std::size_t round = 0; round < graph.size(); ++round)
      for (Node i = 0; i < graph.goal(); ++i)
        for (Node j = 0; j < graph.size(); ++j)
          if (j != graph.start() && i != j && graph.leg(i, j).keeps_limits(0, graph.length(i, j)))
            expected[i] = std::min(expected[i], graph.length(i, j) + expected[j]);
    const RelaxedToGo to_go(graph, RelaxedToGo::Extent::everywhere, run_);
    const RelaxedToGo stopped_early(graph, RelaxedToGo::Extent::until_start, run_);
    for (Node i = 0; i < graph.size(); ++i) {
      if (std::isinf(expected[i])) {
        EXPECT_EQ(to_go(i), expected[i]);
      } else {
        EXPECT_NEAR(to_go(i), expected[i], 1e-6);
      }
    }
    EXPECT_EQ(to_go(graph.start()), stopped_early(graph.start()));
  }
}

TEST_F(RelaxedWay, SuccessorsAreTheMostPromisingAndTheGoalIsKept) {
  const CorrectionGraph graph = graph_of(draw_corrections(CorrectionLaw::set1, 300, 4));
  const RelaxedToGo to_go(graph, RelaxedToGo::Extent::everywhere, run_);
  const Successors all(graph, to_go, 1000, run_);
  const Successors few(graph, to_go, 5, run_);
  EXPECT_EQ(few.longest(), 5U);
  const auto estimate = [&](const Successors::Arc& arc) { return arc.length_m + to_go(arc.to); };
  int goals = 0;
  for (Node i = 0; i < graph.goal(); ++i) {
    const auto list = all.of(i);
    EXPECT_TRUE(std::ranges::is_sorted(list, {}, estimate));
    for (const Successors::Arc& arc : list) {
      EXPECT_EQ(arc.length_m, graph.length(i, arc.to));
      EXPECT_TRUE(graph.leg(i, arc.to).keeps_limits(0, arc.length_m) || arc.to == graph.goal());
    }
    for (Node j = 0; j < graph.size(); ++j) {
      const bool can_follow =
          i != j && j != graph.start() && to_go(j) < kInfinity && graph.leg(i, j).keeps_limits(0, graph.length(i, j));
      EXPECT_TRUE(!can_follow || std::ranges::find(list, j, &Successors::Arc::to) != list.end());
    }
    ASSERT_EQ(few.of(i).size(), std::min<std::size_t>(5, list.size()));
    const auto has_goal = [&](const Successors& one) {
      return std::ranges::find(one.of(i), graph.goal(), &Successors::Arc::to) != one.of(i).end();
    };
    EXPECT_EQ(has_goal(all), has_goal(few));
    goals += has_goal(all) ? 1 : 0;
  }
  EXPECT_GT(goals, 3);
}

}  // namespace
}  // namespace alate
