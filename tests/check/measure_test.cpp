#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"
#include "check/example.hpp"
#include "check/exposure.hpp"
#include "check/leg_shape.hpp"

namespace alate::test {
namespace {

/// Composite Simpson over the leg with `count` pairs of steps.
double simpson(const Threat& threat, const Route& route, int count) {
  const auto density = [&](double t) {
    const Vec3 at = point_on_leg(route, 1, t);
    const bool cylinder = threat.shape == Threat::Shape::cylinder;
    if (cylinder && (at.z() < threat.floor_m || at.z() > threat.top_m)) return 0.0;
    const Vec3 off = at - threat.center;
    const double distance = cylinder ? off.head<2>().norm() : off.norm();
    return threat.level * std::max(0.0, 1 - distance / threat.radius_m);
  };
  const double h = 1.0 / (2 * count);
  double sum = density(0) + density(1);
  for (int i = 1; i < 2 * count; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(i * h);
  return sum * h / 3 * length_of_leg(route, 1);
}

Vec3 random_point(Stream& random) {
  return {2000 * random.uniform() - 1000, 2000 * random.uniform() - 1000, 1000 * random.uniform()};
}

TEST(Exposure, ClosedFormAgreesWithSimpson) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Stream random(seed, 1, 1);
    const Threat threat{.name = "",
                        .shape = seed % 2 == 0 ? Threat::Shape::sphere : Threat::Shape::cylinder,
                        .center = random_point(random) / 2,
                        .radius_m = 200 + 900 * random.uniform(),
                        .level = 0.5,
                        .floor_m = 200,
                        .top_m = 700};
    const Route route = make_route({random_point(random), random_point(random)});
    EXPECT_NEAR(exposure(threat, route, 1), simpson(threat, route, 20000), 0.05);
  }
}

TEST(Exposure, StraightThroughTheCentre) {
  const Threat threat{.name = "", .center = {0, 0, 100}, .radius_m = 100, .level = 2};
  const Route route = make_route({{-500, 0, 100}, {700, 0, 100}});
  EXPECT_NEAR(exposure(threat, route, 1), 2 * 100, 1e-9);
}

TEST(Exposure, VerticalLegInACylinder) {
  const Threat threat{.name = "",
                      .shape = Threat::Shape::cylinder,
                      .center = {0, 0, 0},
                      .radius_m = 100,
                      .level = 1,
                      .floor_m = 50,
                      .top_m = 150};
  EXPECT_NEAR(exposure(threat, make_route({{25, 0, 0}, {25, 0, 1000}}), 1), 0.75 * 100, 1e-9);
}

TEST(Exposure, ArcAgreesWithSimpson) {
  Route route = make_route({{0, 0, 100}, {200, 200, 150}});
  route.states[1].arc = Arc{.center = {200, 0}, .radius_m = 200, .angle_rad = kPi / 2};
  const Threat threat{.name = "", .center = {150, 150, 100}, .radius_m = 120, .level = 1};
  const double reference = simpson(threat, route, 200000);
  EXPECT_NEAR(exposure(threat, route, 1) / reference, 1, 1e-6);
}

TEST(Measure, SizesOfTheExample) {
  const Metrics metrics = measure(example_site(), example_route());
  const double slanted = std::hypot(std::hypot(500, 100), 20);
  EXPECT_NEAR(metrics.length_m, 3 * 500 + std::hypot(500, 20) + std::hypot(500, 100) + slanted, 1e-9);
  EXPECT_NEAR(metrics.climb_m, 20, 1e-9);
  EXPECT_NEAR(metrics.descent_m, 20, 1e-9);
  EXPECT_NEAR(metrics.min_clearance_m.value(), 300 - 187.5, 1e-4);
  EXPECT_GT(metrics.threat, 0);
  EXPECT_NEAR(metrics.cost, metrics.length_m + 20 * metrics.threat + 2 * metrics.climb_m, 1e-9);
}

TEST(Measure, ArcsCountAsTheyAreFlown) {
  Route route = make_route({{0, 0, 100}, {200, 200, 160}});
  route.states[1].arc = Arc{.center = {200, 0}, .radius_m = 200, .angle_rad = kPi / 2};
  const Site nowhere;
  const Metrics metrics = measure(nowhere, route);
  EXPECT_NEAR(metrics.length_m, std::hypot(100 * kPi, 60), 1e-9);
  EXPECT_FALSE(metrics.min_clearance_m);
}

TEST(Measure, Konatowski2019SumsOverNodesWithoutTheStart) {
  Site site;
  site.scenario.objective = {.model = CostModel::konatowski2019, .threat = 0.8, .fuel = 0.2};
  site.mission.goal = {10, 0, 0};
  site.threats = {{.name = "", .center = {4, 3, 0}, .radius_m = 5, .level = 0.5}};
  const Metrics metrics = measure(site, make_route({{0, 0, 0}, {4, 0, 0}, {9, 0, 0}}));
  EXPECT_NEAR(metrics.threat, 0.5 * (5 - 3), 1e-12);
  EXPECT_NEAR(metrics.cost, 0.2 * (6 + 1) + 0.8 * 1, 1e-12);
}

}  // namespace
}  // namespace alate::test
