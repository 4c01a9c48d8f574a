#include "alate/core/executor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace alate {
namespace {

class ExecutorTest : public testing::TestWithParam<int> {};

TEST_P(ExecutorTest, EveryIndexRunsOnce) {
  Executor executor(GetParam());
  EXPECT_EQ(executor.threads(), GetParam());
  for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
    std::vector<int> runs(count, 0);
    executor.for_ranges(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++runs[i];
    });
    EXPECT_EQ(runs, std::vector<int>(count, 1));
  }
}

TEST_P(ExecutorTest, AnExceptionReachesTheCallerAndTheNextLoopRuns) {
  Executor executor(GetParam());
  const auto fail = [](std::size_t begin, std::size_t end) {
    if (begin <= 50 && 50 < end) throw std::runtime_error("50");
  };
  EXPECT_THROW(executor.for_ranges(100, fail), std::runtime_error);
  std::atomic<std::size_t> done{0};
  executor.for_ranges(100, [&](std::size_t begin, std::size_t end) { done += end - begin; });
  EXPECT_EQ(done, 100U);
}

TEST_P(ExecutorTest, ALoopInsideALoopEnds) {
  Executor executor(GetParam());
  std::atomic<std::size_t> done{0};
  executor.for_ranges(20, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      executor.for_ranges(30, [&](std::size_t from, std::size_t to) { done += to - from; });
  });
  EXPECT_EQ(done, 600U);
}

INSTANTIATE_TEST_SUITE_P(Threads, ExecutorTest, testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace alate
