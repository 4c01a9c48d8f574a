#include "space/correction_ants.hpp"

#include <gtest/gtest.h>

#include "aco/ant_space.hpp"
#include "alate/core/stream.hpp"
#include "data/correction_law.hpp"

namespace alate {
namespace {

static_assert(AntSpace<CorrectionAnts>);

class CorrectionAntsTest : public testing::Test {
 protected:
  CorrectionField field_ = draw_corrections(CorrectionLaw::set1, 611, 2);
  CorrectionGraph graph_{field_.navigation, field_.start, field_.goal};
  Executor executor_{1};
  RunContext run_{executor_, {}};
  RelaxedToGo to_go_{graph_, RelaxedToGo::Extent::everywhere, run_};
  Successors successors_{graph_, to_go_, 40, run_};
  RoutePrice price_{.per_m = 1, .per_correction = 100};
  CorrectionAnts ants_{graph_, to_go_, successors_, price_, 100};
};

TEST_F(CorrectionAntsTest, ChoicesAreWhatTheErrorsAllow) {
  Choices choices;
  int closed = 0;
  int open = 0;
  for (std::uint64_t walk = 0; walk < 50; ++walk) {
    Stream stream(1, walk, 0);
    CorrectionState state = ants_.start();
    for (int step = 0; step < 20 && !ants_.is_goal(state); ++step) {
      ants_.look(state, choices);
      const auto arcs = successors_.of(state.node);
      std::vector<std::size_t> may;
      for (std::size_t k = 0; k < choices.cost.size(); ++k) {
        const bool allowed =
            k < arcs.size() && graph_.leg(state.node, arcs[k].to).keeps_limits(state.error, arcs[k].length_m);
        ASSERT_EQ(choices.cost[k] < std::numeric_limits<float>::infinity(), allowed);
        if (k < arcs.size()) ++(allowed ? open : closed);
        if (!allowed) continue;
        may.push_back(k);
        const CorrectionState ahead = ants_.next(state, k);
        EXPECT_EQ(ants_.place(ahead), Eigen::Vector3f(choices.x[k], choices.y[k], choices.z[k]));
        EXPECT_NEAR(static_cast<double>(choices.cost[k]), arcs[k].length_m + (ants_.is_goal(ahead) ? 0 : 100), 0.01);
      }
      if (may.empty()) break;
      state = ants_.next(state, may[stream.below(may.size())]);
    }
  }
  EXPECT_GT(open, 500);
  EXPECT_GT(closed, 500);
}

TEST_F(CorrectionAntsTest, PointsAndActionsAreTheSameRoute) {
  int flown = 0;
  Choices choices;
  for (std::uint64_t walk = 0; walk < 300; ++walk) {
    Stream stream(2, walk, 0);
    std::vector<std::uint32_t> actions;
    CorrectionState state = ants_.start();
    while (!ants_.is_goal(state) && actions.size() < 30) {
      ants_.look(state, choices);
      std::vector<std::uint32_t> may;
      for (std::uint32_t k = 0; k < 8 && k < ants_.actions(); ++k)
        if (choices.cost[k] < std::numeric_limits<float>::infinity()) may.push_back(k);
      if (may.empty()) break;
      actions.push_back(may[stream.below(may.size())]);
      state = ants_.next(state, actions.back());
    }
    const auto flight = ants_.fly(actions);
    ASSERT_EQ(flight.has_value(), ants_.is_goal(state));
    if (!flight) continue;
    ++flown;
    const PointString points = ants_.points(actions);
    EXPECT_EQ(ants_.actions(points), actions);
    const Trip trip = fly(graph_, points);
    EXPECT_TRUE(trip.keeps_limits);
    EXPECT_NEAR(flight->cost, price_.of(trip.length_m, points.size()), 1e-6);
  }
  EXPECT_GT(flown, 20);
}

}  // namespace
}  // namespace alate
