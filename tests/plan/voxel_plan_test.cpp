// Planners among voxels: what they promise, and who serves.
#include <gtest/gtest.h>

#include <random>

#include "alate/check/check.hpp"
#include "support/fly.hpp"
#include "support/voxel_sites.hpp"

namespace alate {
namespace {

using test::fly;

class VoxelPlanner : public testing::TestWithParam<std::string> {};

/// Exact planners as long as Dijkstra's algorithm, theta-star never longer; all proven or checked.
TEST_P(VoxelPlanner, KeepsWhatItPromisesOnDrawnMaps) {
  std::mt19937_64 random(5);
  int without = 0;
  for (int map = 0; map < 150; ++map) {
    const VoxelCell size{2 + static_cast<int>(random() % 9), 2 + static_cast<int>(random() % 9),
                         2 + static_cast<int>(random() % 9)};
    VoxelGrid voxels = test::drawn_voxels(size, static_cast<unsigned>(random() % 50), random);
    voxels.cell_m = 2.5;
    const Site site = test::voxel_site(voxels);
    const double least =
        voxels.cell_m * test::shortest_length(voxels, {0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1});
    const Plan plan = fly(site, {.name = GetParam()});
    if (!std::isfinite(least)) {
      ++without;
      EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
      EXPECT_NE(plan.why.find("blocked cells part the start from the goal"), std::string::npos) << plan.why;
      continue;
    }
    const Verdict verdict = check(site, plan.route);
    EXPECT_TRUE(verdict.ok()) << map;
    const double length = measure(site, plan.route).length_m;
    if (GetParam() == "theta-star") {
      EXPECT_EQ(plan.outcome, Outcome::feasible);
      EXPECT_LE(length, least * (1 + 1e-12)) << map;
      EXPECT_GE(length, plan.lower_bound);
    } else {
      EXPECT_EQ(plan.outcome, Outcome::optimal);
      EXPECT_NEAR(length, least, 1e-9 * least) << map;
      EXPECT_EQ(plan.lower_bound, plan.cost);
    }
  }
  EXPECT_GT(without, 15);
}

TEST_P(VoxelPlanner, FliesStraightInTheOpen) {
  const Plan plan = fly(test::voxel_site(VoxelGrid({9, 9, 9})), {.name = GetParam()});
  EXPECT_EQ(plan.route.states.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Each, VoxelPlanner, testing::Values("jps", "astar", "theta-star"),
                         [](const auto& each) { return each.param == "theta-star" ? "theta_star" : each.param; });

TEST(VoxelPlan, TheSmallerRoomIsNamed) {
  VoxelGrid voxels({9, 9, 9});
  for (int x = 5; x < 9; ++x)
    for (int y = 5; y < 9; ++y)
      for (int z = 5; z < 9; ++z)
        if (x == 5 || y == 5 || z == 5) voxels.block({x, y, z});
  const Plan plan = fly(test::voxel_site(voxels), {.name = "jps"});
  EXPECT_EQ(plan.outcome, Outcome::infeasible_proven);
  EXPECT_NE(plan.why.find("from the goal reach 27 cells only, of which [6, 6, 6] is the nearest to the start"),
            std::string::npos)
      << plan.why;
}

TEST(VoxelPlan, OnlyPlannersAmongVoxelsServe) {
  const World world(test::voxel_site(VoxelGrid({4, 4, 4})));
  for (const PlannerEntry& entry : builtin_planners().entries()) {
    const std::string refusal = entry.refuses(Problem(world));
    EXPECT_EQ(refusal.empty(), entry.can.voxels) << entry.name;
  }
  const ChosenPlanner chosen = choose_planner(builtin_planners(), Problem(world), {});
  EXPECT_EQ(chosen.name, "jps");
  EXPECT_NE(chosen.why.find("exact search"), std::string::npos);
}

TEST(VoxelPlan, SaysWhatItKnowsNothingOf) {
  const auto refusal = [](const auto& change) {
    Site site = test::voxel_site(VoxelGrid({4, 4, 4}));
    change(site);
    const World world(site);
    return builtin_planners().find("jps")->refuses(Problem(world));
  };
  const auto contains = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(refusal([](Site&) {}), "");
  EXPECT_TRUE(contains(refusal([](Site& s) { s.mission.start.z() += 0.1; }), "start.cell"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.voxels->block({3, 3, 3}); }), "goal.cell"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.scenario.objective.climb = 1; }), "objective.climb"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.scenario.objective.length = 0; }), "objective.length"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.vehicle.climb_rad = 0.1; }), "vehicle.climb_deg"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.vehicle.turn_radius_m = 1; }), "vehicle.turn_radius_m"));
  EXPECT_TRUE(contains(refusal([](Site& s) { s.threats.emplace_back(); }), "threats"));
}

}  // namespace
}  // namespace alate
