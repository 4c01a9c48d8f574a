#include "space/correction_graph.hpp"

#include <gtest/gtest.h>

#include <set>

#include "alate/core/stream.hpp"
#include "data/correction_law.hpp"

namespace alate {
namespace {

using Node = CorrectionGraph::Node;

CorrectionGraph graph_of(const CorrectionField& field) { return {field.navigation, field.start, field.goal}; }

TEST(CorrectionGraph, HoldsEveryPointOnceVerticalOnesFirst) {
  const CorrectionField field = draw_corrections(CorrectionLaw::set1, 501, 3);
  const CorrectionGraph graph = graph_of(field);
  ASSERT_EQ(graph.size(), 503U);
  EXPECT_EQ(graph.id(graph.start()), 0);
  EXPECT_EQ(graph.id(graph.goal()), 502);
  EXPECT_EQ(graph.position(graph.start()), field.start);
  EXPECT_EQ(graph.position(graph.goal()), field.goal);
  std::set<int> ids;
  for (Node i = 0; i < graph.point_count(); ++i) {
    const CorrectionPoint& point = field.navigation.points[static_cast<std::size_t>(graph.id(i) - 1)];
    EXPECT_EQ(graph.position(i), point.position);
    EXPECT_EQ(graph.kind(i), point.kind);
    EXPECT_EQ(graph.success(i), point.success);
    EXPECT_EQ(graph.kind(i), i < 251 ? PointKind::vertical : PointKind::horizontal);
    ids.insert(graph.id(i));
  }
  EXPECT_EQ(ids.size(), 501U);
  EXPECT_TRUE(graph.unreliable());
}

TEST(CorrectionGraph, FindsAllNeighboursOfEitherKind) {
  const CorrectionGraph graph = graph_of(draw_corrections(CorrectionLaw::set2, 300, 5));
  for (Node i = 0; i < graph.size(); ++i) {
    for (const PointKind kind : {PointKind::vertical, PointKind::horizontal}) {
      for (const double radius : {0.0, 3'000.0, 20'000.0, 1e6}) {
        std::set<Node> found;
        graph.near(i, kind, radius, [&](Node first, Node last) {
          for (Node j = first; j < last; ++j) EXPECT_TRUE(found.insert(j).second);
        });
        for (Node j = 0; j < graph.point_count(); ++j)
          EXPECT_TRUE(graph.kind(j) != kind || graph.length(i, j) > radius || found.contains(j));
        for (const Node j : found) EXPECT_EQ(graph.kind(j), kind);
      }
    }
  }
}

TEST(CorrectionGraph, KeepsThePointsOfAnEllipse) {
  const CorrectionGraph graph = graph_of(draw_corrections(CorrectionLaw::set1, 400, 7));
  const double length = 1.05 * graph.length(graph.start(), graph.goal());
  const CorrectionGraph part = graph.within(length);
  std::set<int> expected;
  std::set<int> kept;
  for (Node i = 0; i < graph.point_count(); ++i)
    if (graph.length(graph.start(), i) + graph.length(i, graph.goal()) <= length) expected.insert(graph.id(i));
  for (Node i = 0; i < part.point_count(); ++i) kept.insert(part.id(i));
  EXPECT_EQ(kept, expected);
  EXPECT_GT(kept.size(), 20U);
  EXPECT_LT(kept.size(), 380U);
}

TEST(CorrectionGraph, WithoutPointsThereIsNothingNear) {
  const CorrectionGraph graph = graph_of(draw_corrections(CorrectionLaw::set1, 0, 1));
  EXPECT_EQ(graph.size(), 2U);
  EXPECT_FALSE(graph.unreliable());
  graph.near(graph.start(), PointKind::vertical, 1e9, [](Node, Node) { ADD_FAILURE(); });
}

TEST(NavigationError, TheReducedLegIsTheFullOneToTheBit) {
  Navigation navigation = draw_corrections(CorrectionLaw::set1, 0, 1).navigation;
  navigation.drift_horizontal = 0.0013;
  Stream stream(11, 0, 0);
  int kept = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const double error = 20 * stream.uniform();
    const double length = 25'000 * stream.uniform();
    for (const PointKind from : {PointKind::vertical, PointKind::horizontal}) {
      for (const PointKind to : {PointKind::vertical, PointKind::horizontal, PointKind::end}) {
        NavigationError before;
        (from == PointKind::vertical ? before.horizontal : before.vertical) = error;
        const auto full = arrive(navigation, before, length, to);
        const ReducedLeg leg = reduced_leg(navigation, from, to);
        ASSERT_EQ(full.has_value(), leg.keeps_limits(error, length));
        if (!full) continue;
        ++kept;
        EXPECT_LE(length, leg.reach_m(error));
        if (to == PointKind::end) continue;
        EXPECT_EQ(to == PointKind::vertical ? full->horizontal : full->vertical, leg.after(error, length));
        EXPECT_EQ(to == PointKind::vertical ? full->vertical : full->horizontal, 0);
      }
    }
  }
  EXPECT_GT(kept, 10'000);
}

TEST(NavigationError, TheGoalsLimitIsStrictAndTheOthersAreNot) {
  const Navigation navigation = draw_corrections(CorrectionLaw::set1, 0, 1).navigation;
  const ReducedLeg home = reduced_leg(navigation, PointKind::vertical, PointKind::end);
  EXPECT_FALSE(home.keeps_limits(30, 0));
  EXPECT_TRUE(home.keeps_limits(std::nextafter(30, 0), 0));
  EXPECT_FALSE(arrive(navigation, {.horizontal = 30}, 0, PointKind::end));
  EXPECT_TRUE(arrive(navigation, {.horizontal = 15}, 0, PointKind::vertical));
  EXPECT_FALSE(arrive(navigation, {.horizontal = 16}, 0, PointKind::vertical));
}

TEST(NavigationError, AFailedCorrectionLeavesTheResidual) {
  const Navigation navigation = draw_corrections(CorrectionLaw::set1, 0, 1).navigation;
  EXPECT_EQ(failed(navigation, {.vertical = 12, .horizontal = 9}, PointKind::vertical).vertical, 5);
  EXPECT_EQ(failed(navigation, {.vertical = 12, .horizontal = 9}, PointKind::vertical).horizontal, 9);
  EXPECT_EQ(failed(navigation, {.vertical = 3, .horizontal = 9}, PointKind::vertical).vertical, 3);
}

}  // namespace
}  // namespace alate
