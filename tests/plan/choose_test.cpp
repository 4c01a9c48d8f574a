#include <gtest/gtest.h>

#include <algorithm>

#include "alate/plan/registry.hpp"
#include "support/hand_made_sites.hpp"

namespace alate {
namespace {

ChosenPlanner choose(const Site& site, const PlannerRequest& request = {}) {
  const World world(site);
  return choose_planner(builtin_planners(), Problem(world), request);
}

std::vector<Fault> faults_of(const Site& site, const PlannerRequest& request = {}) {
  try {
    choose(site, request);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

Site site_with(PlannerSpec spec) {
  Site site = test::open_air_site();
  site.scenario.file = "a.yaml";
  site.scenario.planner = std::move(spec);
  site.scenario.marks = {{"planner.name", {.file = "a.yaml", .line = 7, .column = 3}},
                         {"planner.preset", {.file = "a.yaml", .line = 8, .column = 3}},
                         {"planner.parameters.width", {.file = "a.yaml", .line = 9, .column = 5}}};
  return site;
}

/// The open air, for an aircraft that only moves in steps.
Site stepping_site() {
  Site site = test::open_air_site();
  site.vehicle.turn_radius_m.reset();
  return site;
}

TEST(Choose, AutoTakesIntervalAStarForATurnRadiusAndSaysWhy) {
  const ChosenPlanner chosen = choose(test::open_air_site());
  EXPECT_EQ(chosen.name, "interval-astar");
  EXPECT_EQ(chosen.chosen_by, "auto");
  EXPECT_NE(chosen.why.find("turn radius"), std::string::npos) << chosen.why;
}

TEST(Choose, AutoTakesBeamForStepsAndSaysWhy) {
  const ChosenPlanner chosen = choose(stepping_site());
  EXPECT_EQ(chosen.name, "beam");
  EXPECT_EQ(chosen.preset, "default");
  EXPECT_EQ(chosen.chosen_by, "auto");
  EXPECT_NE(chosen.why.find("attitude"), std::string::npos) << chosen.why;
}

TEST(Choose, ScenarioBeatsAutoAndOptionBeatsScenario) {
  const Site site = site_with({.name = "greedy", .parameters = {{"score", "J"}}});
  const ChosenPlanner by_scenario = choose(site);
  EXPECT_EQ(by_scenario.name, "greedy");
  EXPECT_EQ(by_scenario.chosen_by, "scenario");
  EXPECT_EQ(by_scenario.parameters.text("score"), "J");
  const ChosenPlanner by_option = choose(site, {.name = "beam"});
  EXPECT_EQ(by_option.name, "beam");
  EXPECT_EQ(by_option.chosen_by, "option");
}

TEST(Choose, SettingsBeatTheScenariosParameters) {
  const Site site = site_with({.name = "beam", .parameters = {{"width", "16"}}});
  EXPECT_EQ(choose(site).parameters.integer("width"), 16);
  const PlannerRequest request{.settings = {{.name = "width", .text = "32", .file = "--set"}}};
  EXPECT_EQ(choose(site, request).parameters.integer("width"), 32);
}

TEST(Choose, ParametersOfAnUnnamedPlannerHoldForTheOneChosen) {
  Site site = site_with({.parameters = {{"width", "16"}}});
  site.vehicle.turn_radius_m.reset();
  EXPECT_EQ(choose(site).parameters.integer("width"), 16);
}

TEST(Choose, UnknownNamesAreFaultsAtTheirPlace) {
  const auto by_option = faults_of(test::open_air_site(), {.name = "baem"});
  ASSERT_EQ(by_option.size(), 1U);
  EXPECT_EQ(by_option[0].file, "--planner");
  EXPECT_NE(by_option[0].message.find("did you mean beam?"), std::string::npos);

  const auto by_scenario = faults_of(site_with({.name = "gredy"}));
  ASSERT_EQ(by_scenario.size(), 1U);
  EXPECT_EQ(by_scenario[0].file, "a.yaml");
  EXPECT_EQ(by_scenario[0].line, 7);
  EXPECT_NE(by_scenario[0].message.find("did you mean greedy?"), std::string::npos);
}

TEST(Choose, EveryFaultOfPresetAndParametersIsReported) {
  const Site site = site_with({.name = "beam", .preset = "defualt", .parameters = {{"width", "0"}}});
  const PlannerRequest request{.settings = {{.name = "step_limit", .text = "many", .file = "--set"},
                                            {.name = "withd", .text = "3", .file = "--set"}}};
  const auto faults = faults_of(site, request);
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(faults[0].line, 8);
  EXPECT_NE(faults[0].message.find("did you mean default?"), std::string::npos);
  EXPECT_EQ(faults[1].line, 9);
  EXPECT_EQ(faults[2].file, "--set");
  EXPECT_NE(faults[3].message.find("did you mean width?"), std::string::npos);
  EXPECT_EQ(faults_of(site, {.preset = "wide"})[0].file, "--preset");
}

TEST(Choose, AVehicleWithoutStepsIsToldWhichKeysToAdd) {
  Site site = test::open_air_site();
  site.scenario.file = "a.yaml";
  site.scenario.marks["vehicle"] = {.file = "a.yaml", .line = 4, .column = 1};
  site.vehicle.step_m.reset();
  site.vehicle.turn_radius_m.reset();
  site.vehicle.roll_rad.clear();
  for (const PlannerRequest& request : {PlannerRequest{}, PlannerRequest{.name = "greedy"}}) {
    const auto faults = faults_of(site, request);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults[0].line, 4);
    const auto told = std::ranges::find_if(faults, [](const Fault& fault) {
      return fault.message.find("vehicle.step_m, vehicle.roll_deg") != std::string::npos;
    });
    ASSERT_NE(told, faults.end());
    EXPECT_EQ(told->message.find("pitch"), std::string::npos);
  }
}

TEST(Registry, EveryPlannerIsFoundDescribedAndComplete) {
  for (const PlannerEntry& entry : builtin_planners().entries()) {
    EXPECT_EQ(builtin_planners().find(entry.name), &entry);
    EXPECT_FALSE(entry.help.empty());
    EXPECT_FALSE(entry.can.space.empty());
    for (const Parameter& parameter : entry.parameters.parameters()) {
      EXPECT_FALSE(parameter.help.empty()) << parameter.name;
      EXPECT_FALSE(parameter.source.empty()) << parameter.name;
    }
    for (const Preset& preset : entry.presets) {
      std::vector<Fault> faults;
      entry.parameters.resolve(preset.values, {}, faults);
      EXPECT_TRUE(faults.empty());
      EXPECT_EQ(entry.find_preset(preset.name), &preset);
    }
    EXPECT_EQ(entry.find_preset("no such preset"), nullptr);
  }
  EXPECT_EQ(builtin_planners().find("no such planner"), nullptr);
}

}  // namespace
}  // namespace alate
