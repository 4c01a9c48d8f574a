// The page and the tables of a study, also where there is little to say.
#include <gtest/gtest.h>

#include <algorithm>

#include "alate/study/study.hpp"
#include "out/xml_balance.hpp"
#include "study/matrix/analysis.hpp"
#include "support/process.hpp"

namespace alate {

namespace {

struct Ran {
  Study study;
  StudyRecords records;
};

Ran run(const std::string& text) {
  const test::TempFolder folder;
  test::write_file(folder / "study<script>.yaml", text);
  Ran ran{.study = load_study((folder / "study<script>.yaml").string()), .records = {}};
  ran.records.resize(ran.study.jobs.size());
  Executor executor(1);
  EXPECT_TRUE(run_study(ran.study, ran.records, executor, {}));
  return ran;
}

void expect_sound(const std::string& html) {
  EXPECT_EQ(test::xml_fault(html), "");
  for (const char* never : {"<script", "nan", "inf,", "href=", "src=", "url("})
    EXPECT_EQ(html.find(never), std::string::npos) << never;
}

TEST(StudyPage, HasEveryPart) {
  const Ran ran =
      run("scenarios: [{grid: {random: {size: [10, 10], obstacles: 0.1, seed: 1..6}}}]\n"
          "planners: [{name: grid-aco, preset: yin2021}, {name: grid-aco, preset: as}]\n"
          "seeds: 1..3\nbudgets: [{iterations: 2}, {iterations: 5}]\n");
  const std::string html = study_html(ran.study, ran.records);
  expect_sound(html);
  for (const char* part : {"In short", "class=\"box w0\"", "class=\"seeds w1\"", "What more time buys", "Wilcoxon",
                           "A pair is a scenario:", "study&lt;script&gt;.yaml"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(StudyPage, IsSoundForASingleRun) {
  const Ran ran =
      run("scenarios: [{grid: {random: {size: [10, 10], obstacles: 0.1, seed: 1}}}]\n"
          "planners: [{name: grid-aco}]\nbudgets: [{iterations: 1}]\n");
  const std::string html = study_html(ran.study, ran.records);
  expect_sound(html);
  EXPECT_EQ(html.find("Wilcoxon"), std::string::npos) << "nothing to compare";
}

TEST(StudyPage, IsSoundWithoutAnyRoute) {
  const Ran ran =
      run("scenarios: [{grid: {random: {size: [10, 10], obstacles: 0.95, seed: 1..2}}}]\n"
          "planners: [{name: grid-aco}, {name: grid-aco, preset: as}]\nbudgets: [{iterations: 1}]\n");
  const std::string html = study_html(ran.study, ran.records);
  expect_sound(html);
  EXPECT_NE(html.find("no planner found a valid route"), std::string::npos);
  EXPECT_NE(rows_csv(ran.study, ran.records).find(",infeasible_proven,,,,,,,"), std::string::npos);
}

/// Grids, and open air that planners on grids refuse.
const std::string kTwoGroups =
    "scenarios:\n"
    "  - {group: 'Grids <b>', scenarios: [{grid: {random: {size: [10, 10], obstacles: 0.1, seed: 1..2}}}]}\n"
    "  - {group: Air, scenarios: [{frame: {local: true}, start: {position_m: [0, 0, 100], heading_deg: 90}, goal: "
    "{position_m: [3000, 500, 100], tolerance_m: 200}, vehicle: {step_m: 200, roll_deg: [0], pitch_deg: [0], yaw_deg: "
    "[-10, 0, 10]}}]}\n"
    "planners: [{name: jps}, {name: grid-aco}, {name: beam}]\n"
    "seeds: 1..3\nbudgets: [{iterations: 2}, {iterations: 20}]\nreference: exact\n";

TEST(StudyGroups, AreTakenByThemselves) {
  const Ran ran = run(kTwoGroups);
  EXPECT_EQ(ran.study.groups, (std::vector<std::string>{"Grids <b>", "Air"}));
  ASSERT_EQ(ran.study.refusals.size(), 3U);
  EXPECT_EQ(ran.study.refusals[0].planner, 2U);
  EXPECT_EQ(ran.study.refusals[1].group, 1U);
  const std::string html = study_html(ran.study, ran.records);
  expect_sound(html);
  for (const char* part : {"Grids &lt;b&gt;: All planners", "Air: In short", "Refused by", "add grid"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_NE(to_text(ran.study, ran.records).find("Air: 1 scenarios"), std::string::npos);
}

TEST(StudyGroups, TellRefusedPairsInTheRows) {
  const Ran ran = run(kTwoGroups);
  const std::string rows = rows_csv(ran.study, ran.records);
  EXPECT_NE(rows.find("Air: 0,jps,default,,,refused,,,,,,,,,,false\n"), std::string::npos) << rows;
  EXPECT_NE(rows.find("Grids <b>: 0 grid.random.seed=2,beam,default,,,refused,"), std::string::npos);
  for (std::size_t at = 0; (at = rows.find('\n', at)) != std::string::npos && at + 1 < rows.size(); ++at) {
    const std::string line = rows.substr(at + 1, rows.find('\n', at + 1) - at - 1);
    EXPECT_EQ(std::ranges::count(line, ','), 15) << line;
  }
}

/// jps proves the optimum, so its own median is 0; ants lie above it or on it, and a planner without routes has a dash.
TEST(StudySummary, TellsTheMedianAboveTheBestKnown) {
  const Ran ran = run(kTwoGroups);
  const std::string text = summary_markdown(ran.study, ran.records);
  for (const char* part :
       {"### Grids \\<b\\>", "2 scenarios, 3 seeds. Best known: the proven optimum of 2 scenarios,",
        "| planner | iterations=2 | iterations=20 | within 1 % after |", "| jps default | +0.00 | +0.00 |", "### Air",
        "1 scenario, 1 seed. Best known: the proven optimum of 0 scenarios,", "| beam default | +"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  EXPECT_EQ(text.find("| beam default | +", text.find("### Air")) != std::string::npos, true);
  EXPECT_EQ(text.find("| grid-aco improved |", text.find("### Air")), std::string::npos) << "it refused this group";
}

/// What is proven at any angle is no optimum from cell to cell, whichever planner the study names first.
TEST(StudySummary, MeasuresFromCellToCellWhereBothAreProven) {
  const Ran ran =
      run("scenarios: [{grid: {random: {size: [30, 30], obstacles: 0.2, seed: 5..6}}}]\n"
          "planners: [{name: theta-star}, {name: astar}, {name: jps}]\n");
  const std::string text = summary_markdown(ran.study, ran.records);
  for (const char* part : {"| theta-star default | -", "| astar default | +0.00", "| jps default | +0.00"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  EXPECT_NE(rows_csv(ran.study, ran.records).find(",astar,default,1,default,optimal,"), std::string::npos);
  for (const MethodFigures& method : analyse(ran.study, ran.records).methods)
    for (const double gap : method.gaps) EXPECT_NEAR(gap, 0, 1e-3) << method.name << " against its own optimum";
}

TEST(StudySummary, LeavesOutMapsWithoutAWay) {
  const Ran ran =
      run("scenarios: [{grid: {random: {size: [10, 10], obstacles: 0.95, seed: 1..2}}}]\n"
          "planners: [{name: grid-aco}]\nbudgets: [{iterations: 1}]\n");
  const std::string text = summary_markdown(ran.study, ran.records);
  EXPECT_NE(text.find("Left out as proven to have no route: 2."), std::string::npos) << text;
  EXPECT_NE(text.find("| grid-aco improved |  | – |"), std::string::npos) << text;
}

/// The published ants seldom arrive in one iteration; a run without a route is worse than any with one.
TEST(StudySummary, CountsRunsWithoutARouteAsWorst) {
  const Ran ran =
      run("scenarios: [" ALATE_SOURCE_DIR
          "/examples/konatowski2019/a.yaml]\n"
          "planners: [{name: greedy}, {name: attitude-aco, preset: konatowski2019, parameters: {ants: 1}}]\n"
          "seeds: 1..3\nbudgets: [{iterations: 1}]\n");
  const std::string text = summary_markdown(ran.study, ran.records);
  EXPECT_NE(text.find("| greedy default | +0.00 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| attitude-aco konatowski2019 ants=1 | – (0 % valid) | – |"), std::string::npos) << text;
}

}  // namespace

}  // namespace alate
