// What we write, our own reader reads back: every format, every state.
#include <gtest/gtest.h>

#include "alate/data/route_file.hpp"
#include "support.hpp"

namespace alate {
namespace {

/// Metres that the fewest decimals of a format may cost.
double rounding_of(const std::string& name) {
  if (name == "result.json" || name == "route.csv") return 1e-6;
  return 0.002;
}

TEST(RoundTripFiles, GiveTheRouteBack) {
  const test::TemporaryFolder folder;
  test::Flight flight;
  flight.find_route();
  write_results(folder.path(), flight.result);
  const auto& states = flight.result.plan.route.states;
  for (const std::string& name : flight.result.files) {
    if (name == "report.html") continue;
    const RouteFile read = load_route(folder.path() / name, flight.site.frame);
    ASSERT_EQ(read.route.states.size(), states.size()) << name;
    for (std::size_t i = 0; i < states.size(); ++i)
      EXPECT_LT((read.route.states[i].position - states[i].position).norm(), rounding_of(name)) << name << " " << i;
  }
}

TEST(RoundTripFiles, RememberScenarioActionsAndArcs) {
  const test::TemporaryFolder folder;
  test::Flight flight;
  flight.find_route();
  flight.result.plan.route.states.push_back({.position = {9100, 7100, 200}, .leg = LegKind::arc});
  flight.result.plan.route.states.back().arc = Arc{.center = {9100, 7000}, .radius_m = 100, .angle_rad = kPi / 2};
  const ArcPlane plane{.center_z_m = 212.5, .normal = {0.6, 0, 0.8}};
  flight.result.plan.route.states.push_back({.position = {9160, 7000, 210}, .leg = LegKind::arc});
  flight.result.plan.route.states.back().arc =
      Arc{.center = {9160, 7100}, .radius_m = 100, .angle_rad = 1, .plane = plane};
  write_results(folder.path(), flight.result);
  const RouteFile read = load_route(folder.path() / "result.json", flight.site.frame);
  EXPECT_EQ(read.format, "result");
  EXPECT_EQ(read.scenario, flight.site.scenario.file);
  EXPECT_EQ(read.overrides, flight.site.scenario.overrides);
  ASSERT_EQ(read.route.states.size(), 6U);
  ASSERT_TRUE(read.route.states[1].action.has_value());
  EXPECT_NEAR(read.route.states[1].action->pitch_rad, radians(3), 1e-12);
  ASSERT_TRUE(read.route.states[4].arc.has_value());
  EXPECT_NEAR(read.route.states[4].arc->angle_rad, kPi / 2, 1e-12);
  EXPECT_FALSE(read.route.states[4].arc->plane);
  ASSERT_TRUE(read.route.states[5].arc.has_value() && read.route.states[5].arc->plane.has_value());
  EXPECT_EQ(read.route.states[5].arc->plane->center_z_m, plane.center_z_m);
  EXPECT_EQ(read.route.states[5].arc->plane->normal, plane.normal);
  EXPECT_EQ(read.route.states[3].point_id, 7);
}

}  // namespace
}  // namespace alate
