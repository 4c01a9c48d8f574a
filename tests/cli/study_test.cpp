// alate study: the same rows however it is run, and none lost when it is killed.
#include <algorithm>
#include <csignal>
#include <thread>

#include "program.hpp"

namespace alate::test {

namespace {

/// Some hundred short runs.
const std::string kStudy =
    "scenarios: [{grid: {random: {size: [16, 16], obstacles: 0.1, seed: 1..4}}}]\n"
    "planners: [{name: grid-aco, preset: yin2021}, {name: grid-aco, preset: as}]\n"
    "seeds: 1..20\n"
    "budgets: [{iterations: 30}]\n";

class StudyRun : public testing::Test {
 protected:
  StudyRun() { write_file(study_, kStudy); }

  std::vector<std::string> words(const std::string& out, const std::string& threads = "2") const {
    return {"study", study_, "--out", (folder_ / out).string(), "--threads", threads};
  }
  std::string rows(const std::string& out) const { return read_file(folder_ / out / "rows.csv"); }
  std::string journal(const std::string& out) const { return read_file(folder_ / out / "journal-0.jsonl"); }

  TempFolder folder_;
  std::string study_ = (folder_ / "study.yaml").string();
};

std::size_t lines_of(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

TEST_F(StudyRun, GivesTheSameRowsAtAnyNumberOfThreads) {
  const Finished one = alate(words("one", "1"));
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(lines_of(rows("one")), 1 + 4 * 2 * 20U);
  EXPECT_TRUE(
      rows("one").starts_with("scenario,planner,preset,seed,budget,outcome,cost,length,height_dev,turns,"
                              "composite,last_change,lower_bound,optimum,gap,valid\n"));
  for (const char* threads : {"2", "8"}) {
    EXPECT_EQ(alate(words(threads, threads)).code, 0);
    EXPECT_EQ(rows(threads), rows("one")) << threads;
  }
  EXPECT_EQ(lines_of(read_file(folder_ / "one/times.csv")), lines_of(rows("one")));
  expect_contains(read_file(folder_ / "one/study.html"), {"<!DOCTYPE html>", "class=\"box w0\"", "class=\"seeds w1\"",
                                                          "Wilcoxon", "Holm", "95 %", "grid-aco yin2021"});
}

TEST_F(StudyRun, GoesOnAfterItWasKilled) {
  ASSERT_EQ(alate(words("whole")).code, 0);
  for (int kills = 0; kills < 3; ++kills) {
    Process process(alate_command(words("killed", "1")));
    const std::size_t before =
        std::filesystem::exists(folder_ / "killed/journal-0.jsonl") ? lines_of(journal("killed")) : 0;
    while (process.running() &&
           (!std::filesystem::exists(folder_ / "killed/journal-0.jsonl") || lines_of(journal("killed")) < before + 10))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.send(SIGKILL);
    EXPECT_EQ(process.wait(20).code, 128 + SIGKILL);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "killed/rows.csv"));
  }
  const Finished done = alate(words("killed"));
  EXPECT_EQ(done.code, 0) << done.err << "a lock that a dead process left must not count";
  EXPECT_EQ(rows("killed"), rows("whole"));
  EXPECT_EQ(lines_of(journal("killed")), lines_of(rows("whole"))) << "no run twice";
}

TEST_F(StudyRun, ForgetsTornLines) {
  ASSERT_EQ(alate(words("whole")).code, 0);
  const std::string whole = journal("whole");
  std::string spoiled = whole.substr(0, whole.size() / 2);
  spoiled[spoiled.size() - 20] ^= 1;
  for (const std::string& torn : {std::string(), whole.substr(0, 10), whole.substr(0, whole.size() / 2), spoiled}) {
    std::filesystem::create_directories(folder_ / "torn");
    write_file(folder_ / "torn/journal-0.jsonl", torn);
    ASSERT_EQ(alate(words("torn")).code, 0) << torn.size();
    EXPECT_EQ(rows("torn"), rows("whole"));
    EXPECT_EQ(lines_of(journal("torn")), lines_of(whole));
  }
}

TEST_F(StudyRun, RefusesTheFolderOfAnotherStudy) {
  ASSERT_EQ(alate(words("out")).code, 0);
  const std::string rows_before = rows("out");
  const std::string journal_before = journal("out");
  write_file(study_, replaced(kStudy, "seeds: 1..20", "seeds: 1..2"));
  const Finished done = alate(words("out"));
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"--out", "another study"});
  EXPECT_EQ(rows("out"), rows_before);
  EXPECT_EQ(journal("out"), journal_before);
}

TEST_F(StudyRun, RefusesTheFolderOfAnotherMap) {
  const std::string map = "type octile\nheight 2\nwidth 4\nmap\n....\n....\n";
  const auto plan_on = [&](const std::string& text) {
    write_file(folder_ / "own.map", text);
    return alate(words("out"));
  };
  write_file(study_,
             "scenarios: [{grid: {map: own.map}, start: {cell: [0, 0]}, goal: {cell: [3, 0]}}]\n"
             "planners: [{name: astar}]\n");
  const Finished first = plan_on(map);
  ASSERT_EQ(first.code, 0) << first.err;
  const Finished again = plan_on(map);
  EXPECT_EQ(again.code, 0) << again.err;
  const Finished other = plan_on(replaced(map, "map\n....", "map\n.@.."));
  EXPECT_EQ(other.code, 2);
  expect_contains(other.err, {"--out", "another study"});
}

TEST_F(StudyRun, StopsOnRequestAndGoesOn) {
  Process process(alate_command(words("out", "1")));
  while (process.running() && !std::filesystem::exists(folder_ / "out/journal-0.jsonl"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.send(SIGINT);
  const Finished stopped = process.wait(20);
  EXPECT_EQ(stopped.code, 130);
  expect_contains(stopped.err, {"interrupted after", "goes on"});
  EXPECT_EQ(alate(words("out")).code, 0);
  EXPECT_EQ(lines_of(rows("out")), 1 + 4 * 2 * 20U);
}

TEST_F(StudyRun, SpreadsOverRanks) {
  if (std::system("command -v mpirun > /dev/null") != 0) GTEST_SKIP() << "mpirun is not there";
  ASSERT_EQ(alate(words("alone")).code, 0);
  for (const char* ranks : {"1", "2", "4"}) {
    Command command = alate_command(words(std::string("ranks") + ranks, "1"));
    // Open MPI leaves some of its own memory behind.
    const std::vector<std::string> mpirun{
        "/usr/bin/env", "ASAN_OPTIONS=detect_leaks=0", "mpirun", "--allow-run-as-root", "--oversubscribe", "-n", ranks};
    command.words.insert(command.words.begin(), mpirun.begin(), mpirun.end());
    const Finished done = run(command);
    ASSERT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(rows(std::string("ranks") + ranks), rows("alone")) << ranks;
  }
  const auto second = read_file(folder_ / "ranks2" / "journal-1.jsonl");
  EXPECT_EQ(lines_of(journal("ranks2")) + lines_of(second), 2 + 4 * 2 * 20U) << "each run once";
}

TEST(Study, TellsFaults) {
  const Finished done = alate({"study", "/nowhere.yaml", "--threads", "0", "--oot", "x"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"no such file", "--threads", "did you mean --out?"});
}

TEST(Study, KnowsTheOptimumWhereAnExactPlannerProvesIt) {
  const TempFolder folder;
  write_file(folder / "study.yaml",
             "scenarios: [" + kCorrectionPoints +
                 "]\nplanners: [{name: correction-aco}]\nseeds: 1..2\nbudgets: [{iterations: 2}]\nreference: exact\n");
  const Finished done = alate({"study", (folder / "study.yaml").string(), "--out", (folder / "out").string()});
  ASSERT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"above the optimum"});
  EXPECT_EQ(lines_of(read_file(folder / "out/rows.csv")), 3U) << "the reference is no row";
}

}  // namespace

}  // namespace alate::test
