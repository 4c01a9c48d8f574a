#include <gtest/gtest.h>

#include "alate/data/scenario_file.hpp"

namespace alate {
namespace {

TEST(ScenarioTemplate, IsValidAndCommented) {
  const std::string text = scenario_template();
  const Scenario scenario = parse_scenario(text, "scenario.yaml");
  EXPECT_TRUE(scenario.terrain.has_value());
  EXPECT_EQ(scenario.threats.size(), 1U);
  EXPECT_NE(text.find("  turn_radius_m: 80  # Least radius of a turn. (m)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  # ceiling_amsl_m:  # Greatest height above mean sea level. (m)\n"), std::string::npos) << text;
}

TEST(ScenarioTemplate, ReadsBackWithoutItsComments) {
  const Scenario scenario = parse_scenario(scenario_template(), "scenario.yaml");
  EXPECT_EQ(parse_scenario(to_yaml(scenario), "scenario.yaml"), scenario) << to_yaml(scenario);
}

}  // namespace
}  // namespace alate
