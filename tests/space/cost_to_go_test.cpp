#include "space/cost_to_go.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

/// A plain without threats.
Site plain_site() {
  Site site = test::ridge_site();
  site.ground = test::raster_of(101, 81, 100, [](double, double) { return 0.0; });
  return site;
}

struct Guided {
  explicit Guided(Site site) : world(std::move(site)), run(executor, {}), guidance(world, run) {}
  double operator()(const Vec3& position) const { return guidance(position); }

  World world;
  Executor executor;
  RunContext run;
  CostToGo guidance;
};

TEST(CostToGo, IsTheStraightDistanceOverAPlainInEveryDirection) {
  constexpr double kCell = 82;  // the upwind update is of first order: it is off by about a cell, near the goal
  const Guided guided(plain_site());
  const Mission& mission = guided.world.site().mission;
  for (double x = 500; x < 7000; x += 450) {
    for (double y = 500; y < 7500; y += 450) {
      const double straight = (mission.goal - Vec3(x, y, 150)).norm() - mission.tolerance_m;
      EXPECT_NEAR(guided({x, y, 150}), straight, kCell) << x << " " << y;
    }
  }
}

TEST(CostToGo, LeadsThroughTheGap) {
  const Guided guided(test::ridge_site());
  const Mission& mission = guided.world.site().mission;
  const double by_gap = (Vec2(5000, 6000) - mission.start.head<2>()).norm() * 2;
  EXPECT_NEAR(guided(mission.start), by_gap, 0.06 * by_gap);
}

TEST(CostToGo, SeesNoWayThroughAClosedWall) {
  const Guided guided(test::ridge_site(false));
  const Mission& mission = guided.world.site().mission;
  EXPECT_EQ(guided(mission.start), kInfinity);
  EXPECT_NEAR(guided.guidance.nearest_reached(mission.start.head<2>()).x(), 5300, 200);
}

TEST(CostToGo, KnowsThatClimbingTakesItsWay) {
  Site site = plain_site();
  site.ground = test::raster_of(101, 81, 100, [](double x, double) { return x > 4950 ? 250.0 : 0.0; });
  site.mission.goal.z() = 500;
  const Guided guided(site);
  const double climb = site.scenario.objective.climb;
  // High up: there is nothing to do but to fly on. Below the edge: 240 m to climb at 8 degrees first, 1700 m of way.
  EXPECT_LT(guided({4000, 2000, 390}), 1.05 * (5000 - 200) + climb * 110);
  EXPECT_GT(guided({4850, 2000, 60}), 4150 - 200 + climb * 240 + 1000);
  EXPECT_LT(guided({4850, 2000, 60}), kInfinity);
}

TEST(CostToGo, KeepsOutOfThreats) {
  const Site site = test::open_air_site();
  const Guided guided(site);
  const double direct = (site.mission.goal - site.mission.start).norm();
  EXPECT_GT(guided(site.mission.start), direct * 1.02);
  EXPECT_LT(guided(site.mission.start), direct * 1.15);
  EXPECT_GT(guided({2500, 350, 300}), guided({2500, 900, 300})) << "inside is dearer than beside";
}

TEST(CostToGo, StopsWhenTold) {
  std::stop_source source;
  source.request_stop();
  Executor executor;
  RunContext run(executor, {.stop = source.get_token()});
  const World world(test::ridge_site());
  const CostToGo guidance(world, run);
  EXPECT_EQ(guidance(world.site().mission.start), kInfinity);
}

}  // namespace
}  // namespace alate
