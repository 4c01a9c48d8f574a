#include "space/objective.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "alate/check/check.hpp"
#include "alate/core/stream.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

/// A sphere and a cylinder, near enough that random legs meet both.
Site site_of(CostModel model) {
  Site site = test::open_air_site();
  site.scenario.objective = {.model = model, .length = 1.5, .threat = 3, .climb = 2, .fuel = 0.7};
  site.threats = {{.name = "sphere", .center = {0, 0, 300}, .radius_m = 500, .level = 0.8},
                  {.name = "cylinder",
                   .shape = Threat::Shape::cylinder,
                   .center = {400, 0, 100},
                   .radius_m = 300,
                   .level = 0.4,
                   .floor_m = 100,
                   .top_m = 350}};
  return site;
}

TEST(Objective, AgreesWithTheSecondWitnessInBothModels) {
  for (const CostModel model : {CostModel::physical, CostModel::konatowski2019}) {
    const World world(site_of(model));
    const Objective objective(world);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Stream stream(seed, 0, 0);
      Route route;
      for (int i = 0; i < 5; ++i) {
        const Vec3 place(1000 * stream.uniform() - 300, 800 * stream.uniform() - 400, 500 * stream.uniform());
        route.states.push_back({.position = place, .leg = i == 0 ? LegKind::start : LegKind::straight});
      }
      const double cost = measure(world.site(), route).cost;
      EXPECT_NEAR(objective.route_cost(route), cost, 1e-6 * cost) << seed;
    }
  }
}

/// Arcs that cross a threat, touch it, or lie in it whole; flown level, up or down.
TEST(Objective, KnowsWhatArcsAreExposedTo) {
  Site site = site_of(CostModel::physical);
  site.scenario.objective = {.model = CostModel::physical, .length = 0, .threat = 1, .climb = 0};
  const World world(site);
  const Objective objective(world);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Stream stream(seed, 2, 0);
    const Vec3 from(1600 * stream.uniform() - 600, 1200 * stream.uniform() - 600, 600 * stream.uniform());
    const Vec2 center = from.head<2>() + Vec2(600 * stream.uniform() - 300, 600 * stream.uniform() - 300);
    const Arc arc{.center = center,
                  .radius_m = (from.head<2>() - center).norm(),
                  .angle_rad = 12 * (stream.uniform() - 0.5),
                  .plane = {}};
    const double rise = seed % 3 == 0 ? 0 : 200 * (stream.uniform() - 0.5);
    const auto at = [&](double t) {
      const Eigen::Rotation2D<double> turn(-arc.angle_rad * t);
      const Vec2 place = center + turn * (from.head<2>() - center);
      return Vec3(place.x(), place.y(), from.z() + t * rise);
    };
    Route route;
    route.states = {{.position = from, .leg = LegKind::start}, {.position = at(1), .leg = LegKind::arc, .arc = arc}};
    constexpr int kSamples = 20'000;
    double sampled = 0;
    for (int k = 0; k < kSamples; ++k)
      sampled += world.exposure({at(static_cast<double>(k) / kSamples), at((k + 1.0) / kSamples)});
    EXPECT_NEAR(objective.route_cost(route), sampled, 1e-6 * (1 + sampled)) << seed;
  }
}

/// Mean over many nodes of the leg of what the node model asks at each.
double sampled_cost(const Objective& nodes, const Segment& leg, const Vec3& goal, double fuel) {
  constexpr int kSamples = 4000;
  double threat = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 at = leg.a + (i + 0.5) / kSamples * (leg.b - leg.a);
    threat += nodes.leg_cost({leg.a, at}) - fuel * (at - goal).norm();
  }
  return fuel * (leg.b - goal).norm() + threat / kSamples;
}

TEST(Objective, ThreatsAtLegsAreTheMeanOfWhatNodesOnTheLegWouldCost) {
  const World world(site_of(CostModel::konatowski2019));
  const Objective nodes(world);
  const Objective legs(world, ThreatsAt::legs);
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Stream stream(seed, 1, 0);
    const auto place = [&] {
      return Vec3(1000 * stream.uniform() - 300, 800 * stream.uniform() - 400, 500 * stream.uniform());
    };
    const Segment leg{place(), place()};
    const double expected = sampled_cost(nodes, leg, world.site().mission.goal, world.site().scenario.objective.fuel);
    EXPECT_NEAR(legs.leg_cost(leg), expected, 1e-3 * expected) << seed;
  }
}

}  // namespace
}  // namespace alate
