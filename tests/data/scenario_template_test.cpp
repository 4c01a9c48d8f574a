#include <gtest/gtest.h>

#include "alate/data/scenario_file.hpp"

namespace alate {
namespace {

TEST(ScenarioTemplate, IsValidAndCommented) {
  const std::string text = scenario_template();
  const Scenario scenario = parse_scenario(text, "scenario.yaml");
  EXPECT_TRUE(scenario.terrain.has_value());
  EXPECT_EQ(scenario.threats.size(), 1U);
  EXPECT_NE(text.find("# Least radius of a turn. (m)\n  turn_radius_m: 80"), std::string::npos) << text;
  EXPECT_NE(text.find("# ceiling_amsl_m:\n"), std::string::npos) << text;
}

TEST(ScenarioTemplate, ReadsBackWithoutItsComments) {
  const Scenario scenario = parse_scenario(scenario_template(), "scenario.yaml");
  EXPECT_EQ(parse_scenario(to_yaml(scenario), "scenario.yaml"), scenario) << to_yaml(scenario);
}

}  // namespace
}  // namespace alate
