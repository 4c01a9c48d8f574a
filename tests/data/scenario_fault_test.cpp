#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "data/scenario_samples.hpp"

namespace alate {
namespace {

using test::faults_in;
using test::kFullScenario;
using test::kSmallScenario;

/// A scenario with one thing wrong, and the fault as users see it.
struct Wrong {
  std::string text;
  std::string shown;
};

void expect_faults(const std::vector<Wrong>& cases) {
  for (const auto& [text, shown] : cases) {
    const auto faults = faults_in(text);
    ASSERT_EQ(faults.size(), 1U) << text << (faults.empty() ? "" : InputError(faults).what());
    EXPECT_EQ(to_string(faults[0]), shown);
  }
}

/// `line` becomes line 6 of a valid scenario.
Wrong added(const std::string& line, const std::string& shown) { return {kSmallScenario + line, shown}; }

/// One change in a valid scenario.
Wrong changed(const std::string& from, const std::string& to, const std::string& shown) {
  return {test::with(kFullScenario, from, to), shown};
}

TEST(ScenarioFault, Keys) {
  expect_faults({
      added("vehicel: {}", "s.yaml:6:1: vehicel: unknown key; did you mean vehicle?"),
      added("lattice: {map: x}",
            "s.yaml:6:1: lattice: unknown key (allowed frame, terrain, grid, start, goal, vehicle, threats, objective, "
            "navigation, planner)"),
      added("goal: {lat: 1}", "s.yaml:6:1: goal: given twice, first in line 5"),
      added("vehicle: {range_m: 1, range_m: 2}", "s.yaml:6:23: vehicle.range_m: given twice, first in line 6"),
      changed("level: 0.5, core_m: 1", "level: 0.5, level: 1",
              "s.yaml:22:66: threats.0.level: given twice, first in line 22"),
      added("[1]: 2", "s.yaml:6:1: a key must be a word"),
      added("vehicle:", "s.yaml:6:1: vehicle: has no value"),
      added("vehicle: {range_m: null}", "s.yaml:6:11: vehicle.range_m: has no value"),
      added("planner: {preset: guided}", "s.yaml:6:1: planner.name: is missing"),
      added("planner: {name: a, parameters: {b: ~}}", "s.yaml:6:33: planner.parameters.b: has no value"),
      {"frame: {local: true}\nstart: {position_m: [1, 2, 3]}\n", "s.yaml:1:1: goal: is missing"},
  });
}

TEST(ScenarioFault, Types) {
  expect_faults({
      added("vehicle: 5", "s.yaml:6:10: vehicle: must be a group of keys (got 5)"),
      added("vehicle: [a]", "s.yaml:6:10: vehicle: must be a group of keys"),
      added("threats: {a: 1}", "s.yaml:6:10: threats: must be a list of groups"),
      added("threats: [a]", "s.yaml:6:11: threats.0: must be a group of keys (got a)"),
      changed("[{center_m: [100, 200], height_m: 300, slope_m: [50, 60]}]", "[]",
              "s.yaml:3:10: terrain.peaks: has the wrong number of items (got 0, allowed 1 to 10000 items)"),
      added("vehicle: {range_m: far}", "s.yaml:6:20: vehicle.range_m: must be a number (got far, allowed > 0 m)"),
      added("vehicle: {range_m: [1]}", "s.yaml:6:20: vehicle.range_m: must be a number"),
      added("vehicle: {range_m: \"5\"}", "s.yaml:6:20: vehicle.range_m: must be a number, without quotes (got 5)"),
      added("objective: {model: cheap}",
            "s.yaml:6:20: objective.model: unknown word (got cheap, allowed physical | konatowski2019)"),
      added("planner: {name: [a]}", "s.yaml:6:17: planner.name: must be text"),
      added("planner: {name: \"\"}", "s.yaml:6:17: planner.name: is empty"),
      added("planner: {name: \"a\\x07\"}",
            "s.yaml:6:17: planner.name: must be one line without control characters (got a\\x07)"),
      changed("origin: {lat: 36.3, lon: -84.25}", "local: yes",
              "s.yaml:1:16: frame.local: must be true or false (got yes)"),
      changed("[10, 20, 30.5]", "[10, 20]",
              "s.yaml:10:20: goal.position_m: has the wrong number of items (got 2, allowed 3 items)"),
      changed("[10, 20, 30.5]", "[10, 20, x]", "s.yaml:10:29: goal.position_m.2: must be a number (got x)"),
      changed("pitch_deg: [0]", "pitch_deg: []",
              "s.yaml:19:14: vehicle.pitch_deg: has the wrong number of items (got 0, allowed 1 to 100 items)"),
      changed("pitch_deg: [0]", "pitch_deg: 0", "s.yaml:19:14: vehicle.pitch_deg: must be a list of numbers (got 0)"),
  });
}

TEST(ScenarioFault, Numbers) {
  const auto speed = [](const std::string& value, const std::string& shown) {
    return added("vehicle: {speed_mps: " + value + "}", "s.yaml:6:22: vehicle.speed_mps: " + shown);
  };
  expect_faults({
      speed("010", "must be a decimal number without leading zeros (got 010, allowed > 0 m/s)"),
      speed("0x1F", "must be a decimal number without leading zeros (got 0x1F, allowed > 0 m/s)"),
      speed("0o17", "must be a decimal number without leading zeros (got 0o17, allowed > 0 m/s)"),
      speed(".nan", "must be finite (got .nan, allowed > 0 m/s)"),
      speed("-.inf", "must be finite (got -.inf, allowed > 0 m/s)"),
      speed("1e999", "is too large or too small for a number (got 1e999, allowed > 0 m/s)"),
      speed("1e10", "is too large (got 1e10, allowed -1000000000 to 1000000000 m/s)"),
      speed("0", "out of range (got 0, allowed > 0 m/s)"),
      speed("-3", "out of range (got -3, allowed > 0 m/s)"),
      changed("climb_deg: 8", "climb_deg: 90",
              "s.yaml:14:14: vehicle.climb_deg: out of range (got 90, allowed > 0 and < 90 deg)"),
      changed("lat: 36.378", "lat: 91", "s.yaml:9:14: start.lat: out of range (got 91, allowed -90 to 90 deg)"),
      changed("-7.5", "-90.5", "s.yaml:18:19: vehicle.roll_deg.1: out of range (got -90.5, allowed -90 to 90 deg)"),
      changed("level: 0.5", "level: -1", "s.yaml:22:61: threats.0.level: out of range (got -1, allowed >= 0)"),
      changed("radius_m: 4", "radius_m: 0", "s.yaml:22:51: threats.0.radius_m: out of range (got 0, allowed > 0 m)"),
      changed("[50, 60]", "[50, 0]", "s.yaml:3:63: terrain.peaks.0.slope_m.1: out of range (got 0, allowed > 0 m)"),
  });
}

TEST(ScenarioFault, KeysThatDoNotGoTogether) {
  const std::string place = "position_m | cell | lat, lon | lat, lon, amsl_m | lat, lon, agl_m";
  const std::string one = "needs exactly one of these sets of keys";
  expect_faults({
      {test::with(kSmallScenario, "local: true", "local: true\n  crs: auto"),
       "s.yaml:2:1: frame: " + one + " (got crs, local, allowed crs | origin | local)"},
      changed("amsl_m: 500, ", "",
              "s.yaml:23:3: threats.1: " + one +
                  " (got lat, lon, allowed center_m | lat, lon, "
                  "amsl_m | lat, lon, agl_m | cylinder)"),
      changed("combine: max", "dem: a.tif",
              "s.yaml:2:1: terrain: " + one + " (got dem, peaks, extent_m, allowed dem | peaks, extent_m)"),
      changed("position_m: [10, 20, 30.5], ", "",
              "s.yaml:10:1: goal: " + one + " (got none of them, allowed " + place + ")"),
      changed("agl_m: 120", "agl_m: 120, amsl_m: 9",
              "s.yaml:9:1: start: " + one + " (got lat, lon, amsl_m, agl_m, allowed " + place + ")"),
      changed("[10, 20, 30.5]", "[10, 20, 30.5], lat: 1, lon: 2, agl_m: 5",
              "s.yaml:10:1: goal: " + one + " (got position_m, lat, lon, agl_m, allowed " + place + ")"),
      changed("center_m: [1, 2], ", "",
              "s.yaml:24:17: threats.2.cylinder: " + one + " (got none of them, allowed center_m | lat, lon)"),
      added("vehicle: {step_m: 5}",
            "s.yaml:6:1: vehicle: " + one + " (got step_m, allowed none | step_m, roll_deg, pitch_deg, yaw_deg)"),
  });
}

TEST(ScenarioFault, FieldsThatContradictEachOther) {
  expect_faults({
      changed("ceiling_agl_m: 400", "ceiling_agl_m: 60",
              "s.yaml:7:18: terrain.ceiling_agl_m: must be above clearance_m (got 60, allowed > 60 m)"),
      changed("core_m: 1", "core_m: 4.5",
              "s.yaml:22:74: threats.0.core_m: must not exceed radius_m (got 4.5, allowed <= 4 m)"),
      changed("floor_m: 0", "floor_m: 90",
              "s.yaml:24:66: threats.2.cylinder.top_m: must be above floor_m (got 90, allowed > 90 m)"),
      changed("name: tower", "name: radar", "s.yaml:24:10: threats.2.name: another threat has this name (got radar)"),
      changed("name: tower", "name: threat 2",
              "s.yaml:24:10: threats.2.name: another threat has this name (got threat 2)"),
      changed("fuel: 0.2", "fuel: 0.3",
              "s.yaml:25:1: objective: fuel + threat must be 1 (0.5 if not given) (got 1.1, allowed 1)"),
      changed("fuel: 0.2", "fuel: 0.2, climb: 1", "s.yaml:25:54: objective.climb: belongs to model physical"),
      added("objective: {fuel: 0.5}", "s.yaml:6:19: objective.fuel: belongs to model konatowski2019"),
      changed("origin: {lat: 36.3, lon: -84.25}", "crs: \"EPSG:32616\"",
              "s.yaml:3:3: terrain.peaks: peaks need a local frame or one with an origin (allowed frame: {local: "
              "true} or {origin: {lat, lon}})"),
      {test::with(kSmallScenario, "position_m: [0, 0, 100]", "lat: 1, lon: 2, amsl_m: 3"),
       "s.yaml:4:14: start.lat: a local frame has no place on Earth; write metres in the frame"},
      added("threats: [{lat: 1, lon: 2, amsl_m: 3, radius_m: 4}]",
            "s.yaml:6:17: threats.0.lat: a local frame has no place on Earth; write metres in the frame"),
      added("threats: [{radius_m: 4, cylinder: {lat: 1, lon: 2, floor_m: 0, top_m: 1}}]",
            "s.yaml:6:41: threats.0.cylinder.lat: a local frame has no place on Earth; write metres in the frame"),
      {"start: {lat: 1, lon: 2, agl_m: 3}\ngoal: {lat: 1, lon: 2, amsl_m: 3}\n",
       "s.yaml:1:32: start.agl_m: needs terrain; without it write amsl_m"},
      {"start: {lat: 1, lon: 2, amsl_m: 3}\ngoal: {position_m: [1, 2, 3]}\n",
       "s.yaml:2:20: goal.position_m: crs: auto needs lat and lon; or name the frame of these metres (allowed frame: "
       "{local: true}, {origin: {lat, lon}} or {crs: \"EPSG:...\"})"},
  });
}

TEST(ScenarioFault, YamlItself) {
  expect_faults({
      {"start: {lat: 1", "s.yaml:1:1: YAML: end of map flow not found"},
      {"start:\n  lat: 1\n lon: 2\n", "s.yaml:3:2: YAML: end of map not found"},
      {"a: \"x", "s.yaml:1:6: YAML: illegal EOF in scalar"},
      {"- a\n- b\n", "s.yaml: a scenario is a group of keys, such as start and goal"},
      {"hello", "s.yaml: a scenario is a group of keys, such as start and goal"},
      {"", "s.yaml: the file is empty"},
      {" \n\n", "s.yaml: the file is empty"},
      {"# nothing\n", "s.yaml: the file is empty"},
      {std::string("a\0b", 3), "s.yaml:1: not a text file in UTF-8"},
      {"a: b\nc: \xff\xfe\n", "s.yaml:2: not a text file in UTF-8"},
      {kSmallScenario + "---\na: 1\n", "s.yaml: holds more than one document"},
      added("vehicle: {range_m: !!int 5}", "s.yaml:6:20: YAML tags are not supported"),
      added("vehicle: *speed", "s.yaml:6:10: YAML: the referenced anchor is not defined"),
  });
}

TEST(ScenarioFault, AliasesAreRefusedBeforeTheyMultiply) {
  std::string text = kSmallScenario + "a0: &a0 [x]\n";
  for (int i = 1; i < 60; ++i) text += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", i, i - 1);
  const auto faults = faults_in(text);
  ASSERT_EQ(faults.size(), 101U);  // 118 aliases and 60 unknown keys, cut off.
  EXPECT_EQ(faults[2].message, "YAML aliases are not supported");
  EXPECT_EQ(faults.back().message, "and 78 more faults");
}

TEST(ScenarioFault, Limits) {
  EXPECT_EQ(to_string(faults_in(std::string(2'000'000, '#')).at(0)), "s.yaml: too large (allowed 1048576 bytes)");
  EXPECT_EQ(to_string(faults_in(std::string(33, '[') + std::string(33, ']')).at(0)),
            "s.yaml:1:33: groups and lists are nested too deeply (allowed 32 levels)");
  std::string many;
  for (int i = 0; i < 10'001; ++i) many += "{},";
  EXPECT_EQ(to_string(faults_in(kSmallScenario + "threats: [" + many + "]").at(0)),
            "s.yaml:6:10: threats: has the wrong number of items (got 10001, allowed 0 to 10000 items)");
  EXPECT_EQ(to_string(faults_in(kSmallScenario + "terrain: {extent_m: [1, 1], peaks: [" + many + "]}").at(0)),
            "s.yaml:6:36: terrain.peaks: has the wrong number of items (got 10001, allowed 1 to 10000 items)");
  std::string angles = "0";
  for (int i = 0; i < 29; ++i) angles += ",1";
  expect_faults({added(fmt::format("vehicle: {{step_m: 1, roll_deg: [{0}], pitch_deg: [{0}], yaw_deg: [{0}]}}", angles),
                       "s.yaml:6:1: vehicle: too many combinations of roll_deg, pitch_deg and yaw_deg (got 27000, "
                       "allowed <= 10000)")});
}

TEST(ScenarioFault, LongValuesAreShortened) {
  const auto faults = faults_in(kSmallScenario + "vehicle: {range_m: " + std::string(5000, 'x') + "}");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].value.size(), 83U);
}

TEST(ScenarioFault, AllOfThemAtOnceInTheOrderOfTheText) {
  const auto faults = faults_in(
      "frame: {local: true}\n"
      "start: {position_m: [0, 0, .nan], heading: 5}\n"
      "goal: {lat: 36, lon: -84, agl_m: 5}\n"
      "vehicle: {climb_deg: 95, climb_deg: 5}\n"
      "threats: [{radius_m: -1, core_m: 5}]\n",
      {"vehicle.speed_mps=fast"});
  std::vector<std::string> fields;
  for (const Fault& fault : faults) fields.push_back(fmt::format("{} {}", fault.line, fault.field));
  EXPECT_EQ(fields, (std::vector<std::string>{"0 vehicle.speed_mps", "2 start.position_m.2", "2 start.heading",
                                              "3 goal.lat", "3 goal.agl_m", "4 vehicle.climb_deg",
                                              "4 vehicle.climb_deg", "5 threats.0", "5 threats.0.radius_m"}));
}

TEST(ScenarioLoad, FilesThatAreNone) {
  const std::filesystem::path folder = testing::TempDir();
  const auto shown = [](const std::string& file) {
    try {
      load_scenario(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no fault");
  };
  EXPECT_EQ(shown("nowhere/s.yaml"), "nowhere/s.yaml: no such file");
  EXPECT_EQ(shown(folder.string()), folder.string() + ": is a folder, not a scenario file");
  EXPECT_EQ(shown("/dev/null"), "/dev/null: the file is empty");
  EXPECT_EQ(shown("/dev/zero"), "/dev/zero: too large (allowed 1048576 bytes)");
}

}  // namespace
}  // namespace alate
