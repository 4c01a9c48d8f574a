// The page and the tables of a study, also where there is little to say.
#include <gtest/gtest.h>

#include "alate/study/study.hpp"
#include "out/xml_balance.hpp"
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

}  // namespace

}  // namespace alate
