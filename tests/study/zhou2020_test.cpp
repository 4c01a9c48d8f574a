// The contest's points are not part of the repository: what needs them is skipped, loudly, where they are absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "alate/core/fault.hpp"
#include "study/zhou2020/claims.hpp"
#include "study/zhou2020/reproduction.hpp"
#include "support/shared_data.hpp"

namespace alate::zhou2020 {
namespace {

const JudgedRow& row(const std::vector<JudgedRow>& rows, std::string_view id) {
  return *std::ranges::find(rows, id, [](const JudgedRow& each) { return std::string_view(each.published->id); });
}

class Zhou2020 : public testing::Test {
 protected:
  void SetUp() override {
    ALATE_NEEDS_SHARED_DATA("correction-points");
    folder_ = test::shared_data("correction-points").string();
  }
  ReproduceOptions options() const { return {.seeds = 1, .iterations = 3, .data = folder_}; }

  std::string folder_;
};

TEST(Zhou2020Paper, EveryRowHasItsOwnId) {
  std::vector<std::string> ids;
  for (const PublishedRoute& each : published_routes()) ids.push_back(each.id);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
  EXPECT_EQ(ids.size(), 19U);
}

TEST(Zhou2020Paper, MissingSetsAreNamed) {
  try {
    find_sets("/nowhere");
    FAIL() << "found sets where there are none";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 2U);
    EXPECT_EQ(error.faults()[0].file, "/nowhere/set1.csv");
    EXPECT_EQ(error.faults()[1].file, "/nowhere/set2.csv");
  }
}

TEST(Zhou2020Paper, LeastLengthKeepsToCorrectionsAndChance) {
  Plan plan;
  plan.front = {{.length_m = 120, .corrections = 8, .probability = 0.9, .points = {}},
                {.length_m = 100, .corrections = 9, .probability = 0.5, .points = {}},
                {.length_m = 130, .corrections = 9, .probability = 1, .points = {}}};
  EXPECT_EQ(least_length(plan, {}, {}), 100);
  EXPECT_EQ(least_length(plan, 8, {}), 120);
  EXPECT_EQ(least_length(plan, {}, 0.995), 130);
  EXPECT_EQ(least_length(plan, 7, {}), std::nullopt);
}

TEST_F(Zhou2020, RoutesAreJudgedAsFlown) {
  Study study = plan_study(options());
  Executor executor(2);
  ASSERT_TRUE(run_experiments({&study.exact, &study.methods}, executor, options()));
  const auto rows = judge_rows(study);
  const JudgedRow& prize = row(rows, "prize-1");
  EXPECT_EQ(prize.claim.verdict, ClaimVerdict::holds);
  EXPECT_NEAR(prize.judged->metrics.length_m, 104898.37, 0.01);
  EXPECT_GT(*prize.gap, 0);
  EXPECT_EQ(row(rows, "table-2").claim.verdict, ClaimVerdict::impossible);
  EXPECT_FALSE(row(rows, "table-2").judged->feasible());
  EXPECT_EQ(row(rows, "greedy-astar-unreliable").claim.verdict, ClaimVerdict::does_not_hold);
  EXPECT_NEAR(*row(rows, "greedy-astar-unreliable").judged->metrics.probability, 0.512, 1e-12);
  EXPECT_EQ(row(rows, "niu-1").claim.verdict, ClaimVerdict::cannot_be_told);
  // Arrivals are what the check saw: errors of the prize route never exceed their limits, and it ends at the goal.
  EXPECT_EQ(prize.judged->arrivals.size(), 9U);
  EXPECT_EQ(prize.judged->arrivals.back().where, "goal");
  EXPECT_NEAR(prize.judged->arrivals.back().flown_m, prize.judged->metrics.length_m, 1e-6);
}

TEST_F(Zhou2020, ThePageHasEveryPart) {
  Executor executor(2);
  const auto result = reproduce(executor, options());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->claims.size(), published_routes().size());
  for (const char* part : {"Routes among the points", "The genetic algorithms", "Adaptive rates over fitness",
                           "First population on set 1", "Errors before each correction", "Proven fronts"})
    EXPECT_NE(result->page.find(part), std::string::npos) << part;
}

TEST_F(Zhou2020, NothingIsShownOfAnInterruptedStudy) {
  std::stop_source source;
  source.request_stop();
  Executor executor(1);
  ReproduceOptions stopped = options();
  stopped.stop = source.get_token();
  EXPECT_FALSE(reproduce(executor, stopped));
}

}  // namespace
}  // namespace alate::zhou2020
