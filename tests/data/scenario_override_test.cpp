#include <gtest/gtest.h>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using test::faults_in;
using test::kFullScenario;
using test::kSmallScenario;

Scenario changed(const std::string& text, const std::vector<std::string>& overrides) {
  return parse_scenario(text, "s.yaml", overrides);
}

TEST(ScenarioOverride, ChangesValuesGroupsAndItems) {
  EXPECT_EQ(changed(kFullScenario, {"vehicle.speed_mps=30"}).vehicle.speed_mps, 30);
  EXPECT_EQ(changed(kFullScenario, {"threats.0.radius_m=5"}).threats[0].radius_m, 5);
  EXPECT_EQ(changed(kFullScenario, {"goal.position_m.1=99"}).goal.place.position_m->at(1), 99);
  EXPECT_EQ(changed(kFullScenario, {"start={position_m: [1, 2, 3]}"}).start.place.position_m->at(0), 1);
  EXPECT_EQ(changed(kFullScenario, {"threats=[]"}).threats.size(), 0U);
}

TEST(ScenarioOverride, MakesWhatIsMissing) {
  EXPECT_EQ(changed(kSmallScenario, {"vehicle.range_m=30"}).vehicle.range_m, 30);
  EXPECT_EQ(changed(kSmallScenario, {"planner.name=p", "planner.parameters.ants=3"}).planner->parameters.at("ants"),
            "3");
  const Scenario first = changed(kSmallScenario, {"threats.0.radius_m=5", "threats.0.center_m=[1, 2, 3]"});
  EXPECT_EQ(first.threats.at(0).center_m->at(2), 3);
  EXPECT_EQ(changed(kFullScenario, {"threats.3={center_m: [1, 2, 3], radius_m: 1}"}).threats.size(), 4U);
}

TEST(ScenarioOverride, LaterOnesWin) {
  EXPECT_EQ(changed(kSmallScenario, {"goal.tolerance_m=1", "goal.tolerance_m=2"}).goal.tolerance_m, 2);
}

TEST(ScenarioOverride, IsKeptAsGiven) {
  const Scenario s = changed(kSmallScenario, {"goal.tolerance_m=1"});
  EXPECT_EQ(s.overrides, std::vector<std::string>{"goal.tolerance_m=1"});
}

TEST(ScenarioOverride, BadSyntaxIsAFault) {
  for (const char* text : {"", "=1", "goal", "goal..x=1", ".goal=1", "goal.=1", "goal.tolerance_m={", "a=[1", "a=*x",
                           "goal.tolerance_m.x=1", "threats.9.radius_m=1", "threats.x=1", "goal={lat: 1, lat: 2}",
                           "threats.99999999999999999999=1", "goal.tolerance_m=", "goal=\x01"}) {
    const auto faults = faults_in(kFullScenario, {text});
    ASSERT_FALSE(faults.empty()) << text;
    EXPECT_EQ(faults[0].file, "--override") << text;
    EXPECT_EQ(faults[0].line, 0) << text;
  }
}

TEST(ScenarioOverride, DeepPathsAreRefused) {
  std::string path = "a";
  for (int i = 0; i < 100'000; ++i) path += ".a";
  const auto faults = faults_in(kSmallScenario, {path + "=1"});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].message, "names more than 32 levels");
}

TEST(ScenarioOverride, FaultsInItNameTheOptionAndNoLine) {
  const auto faults =
      faults_in(kFullScenario, {"threats.0.radius_m=-5", "goal.toleranse_m=1", "terrain.clearance_m=500"});
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(to_string(faults[0]), "--override: goal.toleranse_m: unknown key; did you mean tolerance_m?");
  EXPECT_EQ(to_string(faults[1]), "--override: threats.0.radius_m: out of range (got -5, allowed > 0 m)");
  EXPECT_EQ(to_string(faults[2]),
            "s.yaml:7:18: terrain.ceiling_agl_m: must be above clearance_m (got 400, allowed > 500 m)");
}

}  // namespace
}  // namespace alate
