// Verdicts from results made by hand.
#include "study/konatowski2019/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace alate::konatowski2019 {
namespace {

/// All runs of the method found a route of this cost, by way of one that cost `first`.
void set_costs(Experiment& experiment, std::string_view method, double cost, double first) {
  for (Trial& trial : experiment.trials) {
    if (experiment.methods[trial.method_index].name != method) continue;
    for (StudyRun& run : trial.runs) {
      run.passed = true;
      run.metrics.cost = cost;
      run.plan.history = {{.best_so_far = {}}, {.best_so_far = first}, {.best_so_far = cost}};
    }
  }
}

Study made_up() {
  Study study = plan_study({.seeds = 2});
  for (Experiment* experiment : {&study.main, &study.open})
    for (Trial& trial : experiment->trials)
      for (StudyRun& run : trial.runs) run.plan.lower_bound = 132.608 * 0.8;
  return study;
}

Claim claim(const Study& study, const std::string& id) {
  const auto all = claims(study);
  const auto found = std::ranges::find(all, id, &Claim::id);
  EXPECT_NE(found, all.end()) << id;
  return found == all.end() ? Claim{} : *found;
}

TEST(Claims, OfTheFormulasNeedNoRuns) {
  const Study study = made_up();
  EXPECT_EQ(claim(study, "gain-arithmetic").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim(study, "best-costs-agree").verdict, ClaimVerdict::holds);
  const Claim initial = claim(study, "one-initial-route");
  EXPECT_EQ(initial.verdict, ClaimVerdict::does_not_hold);
  EXPECT_DOUBLE_EQ(*initial.ours, 84.7);
}

TEST(Claims, WithoutRoutesCannotBeTold) {
  const Study study = made_up();
  for (const char* id :
       {"best-0.8-in-open-air", "pheromone-helps", "gain-falls", "gain-falls-ants", "ants-gain-0.5", "best-0.2"}) {
    EXPECT_EQ(claim(study, id).verdict, ClaimVerdict::cannot_be_told) << id;
    EXPECT_FALSE(claim(study, id).ours) << id;
    EXPECT_FALSE(claim(study, id).why.empty()) << id;
  }
}

TEST(Claims, BelowTheBoundIsImpossible) {
  Study study = made_up();
  for (Trial& trial : study.open.trials)
    for (StudyRun& run : trial.runs) run.plan.lower_bound = 111;
  EXPECT_EQ(claim(study, "best-0.8").verdict, ClaimVerdict::impossible);
  EXPECT_EQ(claim(study, "initial-0.8").verdict, ClaimVerdict::cannot_be_told);
}

TEST(Claims, OfPheromoneFollowTheMeans) {
  Study study = made_up();
  set_costs(study.main, kLiteral, 100, 110);
  set_costs(study.main, kNoPheromone, 98, 98);
  const Claim worse = claim(study, "pheromone-helps");
  EXPECT_EQ(worse.verdict, ClaimVerdict::does_not_hold);
  EXPECT_NEAR(*worse.ours, -100.0 * 2 / 98, 1e-12);
  set_costs(study.main, kNoPheromone, 102, 102);
  EXPECT_EQ(claim(study, "pheromone-helps").verdict, ClaimVerdict::holds);
}

TEST(Claims, OfGainsCountFromTheFirstArrival) {
  Study study = made_up();
  set_costs(study.main, kLiteral, 86.3, 100);
  const Claim gain = claim(study, "ants-gain-0.5");
  EXPECT_NEAR(*gain.ours, 13.7, 1e-9);
  EXPECT_EQ(gain.by_case.size(), 3U);
  EXPECT_EQ(claim(study, "ants-gain-0.2").verdict, ClaimVerdict::does_not_hold);
}

TEST(Claims, InOpenAirCompareWithThePublishedBest) {
  Study study = made_up();
  set_costs(study.open, kLiteral, 112, 120);
  EXPECT_EQ(claim(study, "best-0.8-in-open-air").verdict, ClaimVerdict::does_not_hold);
  set_costs(study.open, kLiteral20, 109.9, 120);
  EXPECT_EQ(claim(study, "best-0.8-in-open-air").verdict, ClaimVerdict::cannot_be_told);
}

}  // namespace
}  // namespace alate::konatowski2019
