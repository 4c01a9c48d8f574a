#include "alate/core/run_context.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace alate {
namespace {

using namespace std::chrono_literals;

int count_iterations(RunContext& run, std::uint64_t default_iterations, int at_most = 1000) {
  int count = 0;
  while (count < at_most && run.start_iteration(default_iterations)) ++count;
  return count;
}

TEST(RunContext, RunsThePlannersDefaultAndFinishes) {
  Executor executor;
  RunContext run(executor, {});
  EXPECT_EQ(count_iterations(run, 5), 5);
  EXPECT_EQ(run.iterations(), 5U);
  EXPECT_EQ(run.stop(), Stop::finished);
  EXPECT_EQ(run.seed(), kDefaultSeed);
}

TEST(RunContext, StopsAtTheBudget) {
  Executor executor;
  RunContext run(executor, {.iterations = 3});
  EXPECT_EQ(count_iterations(run, 5), 3);
  EXPECT_EQ(run.stop(), Stop::budget);
  EXPECT_TRUE(run.keep_going()) << "a budget ends iterations, not the one that runs";
}

TEST(RunContext, ATimeLimitAloneLeavesIterationsOpen) {
  Executor executor;
  RunContext run(executor, {.time_limit_s = 60});
  EXPECT_EQ(count_iterations(run, 5, 100), 100);
}

TEST(RunContext, StopsAtTheDeadlineForGood) {
  Executor executor;
  RunContext run(executor, {.iterations = 1000000000, .time_limit_s = 0.01});
  EXPECT_TRUE(run.keep_going());
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(run.keep_going());
  EXPECT_FALSE(run.start_iteration(5));
  EXPECT_EQ(run.stop(), Stop::deadline);
}

TEST(RunContext, StopsWhenCancelled) {
  Executor executor;
  std::stop_source source;
  RunContext run(executor, {.time_limit_s = 60, .stop = source.get_token()});
  EXPECT_TRUE(run.keep_going());
  source.request_stop();
  EXPECT_FALSE(run.start_iteration(5));
  EXPECT_EQ(run.stop(), Stop::cancelled);
}

TEST(RunContext, ALateDeadlineDoesNotHideACancel) {
  Executor executor;
  std::stop_source source;
  RunContext run(executor, {.time_limit_s = 0.01, .stop = source.get_token()});
  source.request_stop();
  EXPECT_FALSE(run.keep_going());
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(run.keep_going());
  EXPECT_EQ(run.stop(), Stop::cancelled);
}

TEST(RunContext, ReportsProgressButNotTooOften) {
  Executor executor;
  std::vector<Progress> seen;
  RunContext run(executor, {.iterations = 4, .on_progress = [&](const Progress& p) { seen.push_back(p); }});
  std::this_thread::sleep_for(110ms);
  run.start_iteration(1);
  run.report(12.5);
  run.report(12.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].iteration, 1U);
  EXPECT_DOUBLE_EQ(seen[0].fraction, 0.25);
  EXPECT_EQ(seen[0].best, 12.5);
}

}  // namespace
}  // namespace alate
