#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using test::kFullScenario;
using test::kSmallScenario;

TEST(ScenarioRead, EveryField) {
  const Scenario s = parse_scenario(kFullScenario, "s.yaml");
  EXPECT_EQ(s.frame.origin->lon_deg, -84.25);
  ASSERT_EQ(s.terrain->peaks.size(), 1U);
  EXPECT_EQ(s.terrain->peaks[0].slope_m[1], 60);
  EXPECT_EQ(s.terrain->combine, PeakCombination::max);
  EXPECT_EQ(s.terrain->extent_m->at(1), 2000);
  EXPECT_EQ(s.terrain->clearance_m, 60);
  EXPECT_EQ(s.terrain->ceiling_agl_m, 400);
  EXPECT_EQ(s.terrain->ceiling_amsl_m, 1500);
  EXPECT_EQ(s.start.place.lat_deg, 36.378);
  EXPECT_EQ(s.start.place.agl_m, 120);
  EXPECT_EQ(s.start.heading_deg, 225);
  EXPECT_EQ(s.goal.place.position_m->at(2), 30.5);
  EXPECT_EQ(s.goal.tolerance_m, 300);
  EXPECT_EQ(s.vehicle.descent_deg, 10);
  EXPECT_EQ(s.vehicle.roll_deg.size(), 5U);
  EXPECT_EQ(s.threats[0].level, 0.5);
  EXPECT_EQ(s.threats[1].name, "threat 2");
  EXPECT_EQ(s.threats[2].cylinder->top_m, 90);
  EXPECT_EQ(s.objective.threat, 0.8);
  EXPECT_EQ(s.planner->parameters.at("ants"), "20");
  EXPECT_EQ(s.planner->parameters.at("score"), "J+h");
}

TEST(ScenarioRead, DefaultsAreThoseOfTheModel) {
  const Scenario physical = parse_scenario(kSmallScenario, "s.yaml");
  EXPECT_EQ(physical.objective.threat, 20);
  EXPECT_FALSE(physical.terrain || physical.planner || physical.start.heading_deg);
  const Scenario other = parse_scenario(kSmallScenario + "objective: {model: konatowski2019}", "s.yaml");
  EXPECT_EQ(other.objective.threat, 0.5);
  EXPECT_EQ(other.objective.fuel, 0.5);
}

TEST(ScenarioRead, JsonIsYaml) {
  const Scenario s = parse_scenario(
      R"({"frame": {"local": true}, "start": {"position_m": [0, 0, 1e2]}, "goal": {"position_m": [1000, 0, 100]}})",
      "s.json");
  EXPECT_EQ(s, parse_scenario(kSmallScenario, "s.yaml"));
}

TEST(ScenarioRead, ByteOrderMarkAndWindowsLineEndsChangeNothing) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : kSmallScenario) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parse_scenario(text, "s.yaml"), parse_scenario(kSmallScenario, "s.yaml"));
}

TEST(ScenarioRead, MarksSayWhereFieldsStand) {
  const Scenario s = parse_scenario(kFullScenario, "s.yaml", {"goal.tolerance_m=5"});
  EXPECT_EQ(mark_of(s, "terrain").line, 2);
  EXPECT_EQ(mark_of(s, "terrain.clearance_m").line, 6);
  EXPECT_EQ(mark_of(s, "terrain.clearance_m").column, 16);
  EXPECT_EQ(mark_of(s, "threats.1").line, 23);
  EXPECT_EQ(mark_of(s, "threats.1.agl_m").line, 23);
  EXPECT_EQ(mark_of(s, "start.position_m").line, 9);
  EXPECT_EQ(mark_of(s, "goal.tolerance_m").file, "--override");
  EXPECT_EQ(mark_of(s, "planner.parameters.ants").column, 66);
}

TEST(ScenarioRead, PathsStartAtTheFolderOfTheirFile) {
  const std::string dem = "terrain: {dem: ground/a.tif}";
  EXPECT_EQ(parse_scenario(kSmallScenario + dem, "folder/s.yaml").terrain->dem, "folder/ground/a.tif");
  EXPECT_EQ(parse_scenario(kSmallScenario + dem, "s.yaml").terrain->dem, "ground/a.tif");
  EXPECT_EQ(parse_scenario(kSmallScenario + "terrain: {dem: /a.tif}", "folder/s.yaml").terrain->dem, "/a.tif");
  EXPECT_EQ(parse_scenario(kSmallScenario + dem, "folder/s.yaml", {"terrain.dem=b.tif"}).terrain->dem, "b.tif");
}

TEST(ScenarioRead, NamesAreTextWhateverTheySay) {
  const std::string threat = "threats: [{name: X, center_m: [0, 0, 0], radius_m: 1}]";
  const auto name_of = [&](const std::string& written) {
    return parse_scenario(kSmallScenario + test::with(threat, "X", written), "s.yaml").threats[0].name;
  };
  EXPECT_EQ(name_of("<script>alert(1)</script>"), "<script>alert(1)</script>");
  EXPECT_EQ(name_of("010"), "010");
  EXPECT_EQ(name_of("\"null\""), "null");
  EXPECT_EQ(name_of("\"\""), "threat 1");
  EXPECT_EQ(name_of("Züri"), "Züri");
}

TEST(ScenarioLoad, ReadsAFile) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "alate_scenario_load.yaml";
  std::ofstream(file) << kFullScenario;
  EXPECT_EQ(load_scenario(file.string()), parse_scenario(kFullScenario, "s.yaml"));
  EXPECT_EQ(load_scenario(file.string(), {"goal.tolerance_m=7"}).goal.tolerance_m, 7);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace alate
