// Reading of studies: ranges, labels, runs laid out, every fault at once.
#include <gtest/gtest.h>

#include <algorithm>

#include "alate/core/fault.hpp"
#include "alate/study/study.hpp"
#include "study/matrix/ranges.hpp"
#include "support/process.hpp"

namespace alate {

namespace {

const std::string kGrid = "scenarios: [{grid: {random: {size: [8, 8], obstacles: 0.1, seed: 1..3}}}]\n";

Study load(const std::string& text) {
  const test::TempFolder folder;
  test::write_file(folder / "study.yaml", text);
  return load_study((folder / "study.yaml").string());
}

/// "line:column field message" of every fault.
std::vector<std::string> faults_of(const std::string& text) {
  std::vector<std::string> told;
  try {
    load(text);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults())
      told.push_back(std::to_string(fault.line) + ":" + std::to_string(fault.column) + " " + fault.field + " " +
                     fault.message);
  }
  return told;
}

TEST(StudyFile, WritesRangesOut) {
  const Study study = load(kGrid + "planners: [{name: grid-aco}]\nseeds: 4..5\nbudgets: [{iterations: 2}]\n");
  ASSERT_EQ(study.scenarios.size(), 3U);
  EXPECT_EQ(study.scenarios[1].name, "scenario 0 grid.random.seed=2");
  EXPECT_EQ(study.jobs.size(), 6U);
  EXPECT_EQ(study.jobs[3].scenario, 1U);
  EXPECT_EQ(study.jobs[3].seed, 5U);
  EXPECT_EQ(study.budgets.front().text(), "iterations=2");
}

TEST(StudyFile, CrossesSeveralRanges) {
  std::vector<Fault> faults;
  const Node node = parse_document("{a: 1..2, b: {c: [5, 7..9]}, d: \"1..2\"}", "", faults);
  EXPECT_EQ(expanded_count(node, 6), 6U);
  EXPECT_EQ(expanded_count(node, 5), 0U);
  const std::vector<Expanded> all = expand(node);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[4].chosen, "a=2 b.c.1=8");
  EXPECT_EQ(all[4].node.find("d")->text, "1..2") << "text in quotes stays text";
}

TEST(StudyFile, FliesARandomGridFromCornerToCorner) {
  const Study study = load(kGrid + "planners: [{name: grid-aco}]\n");
  const Mission& mission = study.scenarios.front().world.site().mission;
  EXPECT_LT(mission.start.x(), 1);
  EXPECT_LT(mission.start.y(), 1);
  EXPECT_GT(mission.goal.x(), 7);
  EXPECT_GT(mission.goal.y(), 7);
}

TEST(StudyFile, RunsPlannersWithoutChanceOnce) {
  const std::string open =
      "scenarios: [{frame: {local: true}, start: {position_m: [0, 0, 100], heading_deg: 90}, goal: {position_m: [3000, "
      "500, 100], tolerance_m: 200}, vehicle: {step_m: 200, roll_deg: [0], pitch_deg: [0], yaw_deg: [-10, 0, 10]}}]\n";
  const Study study = load(open + "planners: [{name: beam}, {name: attitude-aco}]\nseeds: 1..5\n");
  EXPECT_EQ(std::ranges::count(study.jobs, 0U, &StudyJob::planner), 1);
  EXPECT_EQ(std::ranges::count(study.jobs, 1U, &StudyJob::planner), 5);
}

TEST(StudyFile, TellsEveryFaultAtOnce) {
  const std::vector<std::string> faults = faults_of(
      "scenarios:\n"
      "  - nowhere.yaml\n"
      "  - {grid: {random: {size: [8, 8], obstacels: 0.1, seed: 1}}}\n"
      "planners:\n"
      "  - {name: grid-acco}\n"
      "  - {name: grid-aco, preset: improve, parameters: {ants: -1}}\n"
      "  - {nam: beam}\n"
      "seeds: 3..1\n"
      "budgets: [{iterations: 0}, {}]\n"
      "references: exact\n");
  const std::vector<std::string> parts{"no such file",
                                       "3:36 scenarios.1.grid.random.obstacels unknown key; did you mean obstacles?",
                                       "5:12 planners.0.name unknown planner; did you mean grid-aco?",
                                       "6:30 planners.1.preset",
                                       "6:58 ants out of range",
                                       "7:6 planners.2.nam unknown key; did you mean name?",
                                       "8:8 seeds",
                                       "9:24 budgets.0.iterations out of range",
                                       "9:28 budgets.1 needs exactly one of these keys",
                                       "10:1 references unknown key; did you mean reference?"};
  for (const std::string& part : parts)
    EXPECT_TRUE(std::ranges::any_of(faults, [&](const auto& each) { return each.find(part) != std::string::npos; }))
        << part;
}

TEST(StudyFile, PassesOnAPlannersOwnRefusal) {
  const auto faults = faults_of(kGrid + "planners: [{name: beam}]\n");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("2:19 planners.0.name beam cannot plan scenario 0 grid.random.seed=1: it"),
            std::string::npos)
      << faults[0];
  EXPECT_NE(faults[0].find("and it refuses 2 more scenarios"), std::string::npos) << faults[0];
}

TEST(StudyFile, RefusesEmptyListsAndAbsurdCounts) {
  EXPECT_EQ(faults_of("scenarios: []\nplanners: []\nseeds: []\nbudgets: []\n").size(), 4U);
  for (const char* text : {"seeds: 0..999999999\n",
                           "seeds: 1..99999\nbudgets: [{iterations: 1}, {iterations: 2}, "
                           "{iterations: 3}, {iterations: 4}]\n"})
    EXPECT_FALSE(faults_of(kGrid + "planners: [{name: grid-aco}]\n" + text).empty()) << text;
  EXPECT_FALSE(faults_of("scenarios: [{grid: {random: {size: [8, 8], obstacles: 0.1, seed: 1..999999999}}}]\n"
                         "planners: [{name: grid-aco}]\n")
                   .empty());
  EXPECT_FALSE(faults_of(kGrid + "planners: [{name: grid-aco}, {name: grid-aco}]\n").empty()) << "given twice";
}

TEST(StudyFile, AGroupIsServedAsAWholeOrNotAtAll) {
  const std::string grid = "{grid: {random: {size: [8, 8], obstacles: 0.1, seed: 1}}}";
  const std::string air =
      "{frame: {local: true}, start: {position_m: [0, 0, 100], heading_deg: 90}, goal: {position_m: [3000, 500, 100], "
      "tolerance_m: 200}, vehicle: {step_m: 200, roll_deg: [0], pitch_deg: [0], yaw_deg: [-10, 0, 10]}}";
  const std::string groups = "scenarios: [{group: a, scenarios: [" + grid + "]}, {group: b, scenarios: [" + air + "]}";
  EXPECT_EQ(load(groups + "]\nplanners: [{name: jps}, {name: beam}]\n").jobs.size(), 2U);
  const auto mixed =
      faults_of(groups + ", {group: c, scenarios: [" + grid + ", " + air + "]}]\nplanners: [{name: jps}]\n");
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_NE(mixed[0].find("jps cannot plan c: 1: it"), std::string::npos) << mixed[0];
  const auto none = faults_of(groups + "]\nplanners: [{name: label-setting}]\n");
  ASSERT_EQ(none.size(), 1U) << "it serves no group";
  const auto twice = faults_of("scenarios: [{group: a, scenarios: [" + grid + "]}, {group: a, scenarios: [" + grid +
                               "]}, {group: d, scenaros: []}]\nplanners: [{name: jps}]\n");
  ASSERT_EQ(twice.size(), 3U);
  EXPECT_NE(twice[0].find("a name of its own"), std::string::npos) << twice[0];
}

}  // namespace

}  // namespace alate
