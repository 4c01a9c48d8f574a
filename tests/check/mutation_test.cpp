// Breaks one rule at a time by one small change of a valid route: check must name that rule and no other.
#include <gtest/gtest.h>

#include <cmath>

#include "check/example.hpp"

namespace alate::test {
namespace {

using Legs = std::set<std::size_t>;

struct Mutation {
  std::string name;
  std::string rule;
  Legs legs;
  std::function<void(Site&, Route&)> change;
};

void PrintTo(const Mutation& mutation, std::ostream* out) { *out << mutation.name; }

/// Puts state `i` elsewhere.
std::function<void(Site&, Route&)> move(std::size_t i, const Vec3& to) {
  return [i, to](Site&, Route& route) { route.states[i].position = to; };
}

void raise_ridge(Site& site, Route& /*route*/) {
  auto& raster = std::get<HeightRaster>(site.ground);
  const auto columns = static_cast<std::size_t>(raster.columns);
  for (std::size_t post = 12; post < raster.posts.size(); post += columns) raster.posts[post] = 280;
}

const std::vector<Mutation> kMutations{
    {"IntoTheGround", "terrain_clearance", {3, 4}, move(3, {2000, 250, 190})},
    {"RidgeBetweenTheEnds", "terrain_clearance", {2}, raise_ridge},
    {"CeilingAboveGround", "ceiling", {1, 2}, move(1, {1000, 150, 440})},
    {"CeilingAboveSea", "ceiling", {5, 6}, move(5, {3000, 350, 460})},
    {"IntoASphere", "threat_core", {3, 4}, move(3, {2000, 550, 320})},
    {"IntoACylinder", "threat_core", {2}, [](Site& site, Route&) { site.threats[1].center = {1250, 240, 0}; }},
    {"TightCorner", "turn", {2, 3}, move(2, {1100, 350, 320})},
    {"OffTheStartHeading", "turn", {1}, [](Site& site, Route&) { site.mission.heading_rad = radians(-45); }},
    {"SteepClimb", "climb", {2}, move(2, {1040, 150, 320})},
    {"SteepDescent", "descent", {4}, move(4, {2040, 258, 300})},
    {"OutOfTheArea", "bounds", {3, 4}, move(3, {2000, -20, 320})},
    {"ShortOfTheGoal", "arrival", {5}, [](Site&, Route& route) { route.states.pop_back(); }},
    {"WrongStart", "arrival", {0}, move(0, {498, 150, 300})},
    {"BeyondItsRange", "endurance", {6}, [](Site& site, Route&) { site.vehicle.range_m = 3000; }},
};

TEST(Mutation, BaseRoutePassesWithPositiveMargins) {
  const Verdict verdict = check(example_site(), example_route());
  EXPECT_EQ(verdict.status, Status::pass);
  EXPECT_TRUE(verdict.violations.empty());
  EXPECT_EQ(verdict.margins.size(), 9U);
  for (const Margin& margin : verdict.margins) EXPECT_GT(margin.margin, 0) << margin.rule;
  std::vector<std::string> not_checked;
  for (const NotChecked& each : verdict.not_checked) not_checked.push_back(each.rule);
  EXPECT_EQ(not_checked, (std::vector<std::string>{"step", "vertical_error", "horizontal_error", "final_error"}));
}

class OneMutation : public testing::TestWithParam<Mutation> {};

TEST_P(OneMutation, BreaksItsRuleAndNoOther) {
  Site site = example_site();
  Route route = example_route();
  GetParam().change(site, route);
  const Verdict verdict = check(site, route);
  EXPECT_EQ(verdict.status, Status::fail);
  EXPECT_EQ(broken_rules(verdict), std::set<std::string>{GetParam().rule});
  EXPECT_EQ(broken_legs(verdict), GetParam().legs);
  ASSERT_NE(find_margin(verdict, GetParam().rule), nullptr);
  EXPECT_LT(find_margin(verdict, GetParam().rule)->margin, 0);
}

INSTANTIATE_TEST_SUITE_P(Each, OneMutation, testing::ValuesIn(kMutations),
                         [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace alate::test
