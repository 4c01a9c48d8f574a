#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using Json = nlohmann::json;

std::string text_of_file(const std::string& file) {
  std::ifstream stream(std::string(ALATE_SOURCE_DIR "/") + file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ScenarioDocs, ManualIsUpToDate) {
  EXPECT_TRUE(text_of_file("docs/scenario.md") == scenario_manual())
      << "Regenerate it: alate schema --markdown > docs/scenario.md";
}

TEST(ScenarioDocs, SchemaIsUpToDate) {
  EXPECT_TRUE(text_of_file("docs/scenario.schema.json") == scenario_json_schema())
      << "Regenerate it: alate schema > docs/scenario.schema.json";
}

const Json& keys_of(const Json& schema) { return schema.at("properties"); }

TEST(ScenarioSchema, HoldsEveryKeyWithTypeLimitsAndMeaning) {
  const Json schema = Json::parse(scenario_json_schema());
  EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_FALSE(schema.contains("required"));
  for (const std::size_t i : {0U, 1U}) {
    const Json either = {{{"required", {i == 0 ? "start" : "goal"}}}, {{"required", {"navigation"}}}};
    EXPECT_EQ(schema.at("allOf").at(i).at("anyOf"), either);
  }
  EXPECT_EQ(schema.at("additionalProperties"), false);
  const std::map<std::string, std::vector<std::string>> keys{
      {"frame", {"crs", "origin", "local"}},
      {"terrain", {"dem", "peaks", "combine", "extent_m", "clearance_m", "ceiling_agl_m", "ceiling_amsl_m"}},
      {"grid", {"map", "random", "dem", "level_amsl_m", "clearance_m", "heights", "cell_m"}},
      {"start", {"position_m", "cell", "lat", "lon", "amsl_m", "agl_m", "heading_deg"}},
      {"goal", {"position_m", "cell", "lat", "lon", "amsl_m", "agl_m", "tolerance_m"}},
      {"vehicle",
       {"speed_mps", "turn_radius_m", "climb_deg", "descent_deg", "range_m", "step_m", "roll_deg", "pitch_deg",
        "yaw_deg"}},
      {"objective", {"model", "length", "threat", "climb", "fuel"}},
      {"navigation",
       {"points", "drift_per_m", "alpha", "beta", "theta", "success", "residual", "turn_radius_m", "turn_model"}},
      {"planner", {"name", "preset", "parameters"}}};
  for (const auto& [group, fields] : keys) {
    for (const std::string& field : fields) {
      ASSERT_TRUE(keys_of(keys_of(schema).at(group)).contains(field)) << group << "." << field;
      EXPECT_FALSE(keys_of(keys_of(schema).at(group)).at(field).at("description").empty());
    }
  }
  const Json& threat = keys_of(schema).at("threats").at("items");
  for (const char* field :
       {"name", "center_m", "lat", "lon", "amsl_m", "agl_m", "cylinder", "radius_m", "level", "core_m"})
    EXPECT_TRUE(keys_of(threat).contains(field)) << field;
  EXPECT_EQ(keys_of(threat).at("level").at("default"), 1);
  EXPECT_EQ(keys_of(threat).at("radius_m").at("exclusiveMinimum"), 0);
  EXPECT_EQ(threat.at("oneOf").size(), 4U);
  EXPECT_EQ(keys_of(keys_of(schema).at("vehicle")).at("climb_deg").at("exclusiveMaximum"), 90);
}

TEST(ScenarioManual, SaysTypeUnitDefaultLimitAndMeaning) {
  const std::string manual = scenario_manual();
  for (const char* row : {"| `climb_deg` | number | deg |  | > 0 and < 90 | Steepest climb. |",
                          "| `radius_m` | number | m | required | > 0 |", "| `level` | number |  | 1 | >= 0 |",
                          "## `threats[].cylinder`", "`crs`, or `origin`, or `local`", "| bytes of a file | 1048576 |"})
    EXPECT_NE(manual.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace alate
