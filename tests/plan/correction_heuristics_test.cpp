// Heuristic planners on correction points: what they find, against the exact search and against trying everything.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/plan/registry.hpp"
#include "search/correction_oracles.hpp"
#include "space/candidates.hpp"
#include "support/correction_sites.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

using test::fly;

struct Heuristic {
  const char* planner;
  const char* preset;
};

const std::vector<Heuristic> kAll{{"correction-ga", "improved"},       {"correction-ga", "zhou2020"},
                                  {"correction-ga", "zhou2020-plain"}, {"sparse-astar", "corrected"},
                                  {"sparse-astar", "zhou2020"},        {"sparse-astar", "zhou2020-plain"},
                                  {"correction-aco", "mmas"},          {"correction-aco", "as"}};

bool arrived(const Plan& plan) { return plan.outcome == Outcome::feasible || plan.outcome == Outcome::optimal; }

Plan plan_with(const Problem& problem, const PlannerRequest& request) {
  Executor executor(2);
  RunContext run(executor, {});
  return choose_planner(builtin_planners(), problem, request).planner.plan(problem, run);
}

/// Judged by `check`, which shares no code with the planners.
void expect_sound(const Site& site, const Plan& plan, double shortest_m, const std::string& name) {
  EXPECT_LE(plan.lower_bound, shortest_m * (1 + 1e-12)) << name;
  if (!arrived(plan)) {
    EXPECT_FALSE(plan.why.empty()) << name;
    return;
  }
  EXPECT_TRUE(check(site, plan.route).ok()) << name;
  EXPECT_NEAR(plan.cost, measure(site, plan.route).length_m, 1e-9 * plan.cost) << name;
  EXPECT_GE(plan.cost, shortest_m * (1 - 1e-12)) << name;
  EXPECT_TRUE(plan.outcome != Outcome::optimal || plan.cost <= shortest_m * (1 + 1e-9)) << name;
}

/// Length of the shortest route with up to four corrections; infinite if there is none.
double shortest_by_trying(const CorrectionField& field) {
  double best = kInfinity;
  test::for_each_walk(field, 4,
                      [&](double length, const std::vector<std::size_t>& /*walk*/) { best = std::min(best, length); });
  return best;
}

TEST(CorrectionHeuristics, NeverBeatTryingEverythingOnTinySets) {
  int found = 0;
  int none = 0;
  int best_of_ga = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const CorrectionField field = test::small_field(8 + static_cast<int>(seed % 8), 36'000, seed);
    const Site site = test::correction_site(field);
    const World world(site);
    const Plan exact = fly(world, {.name = "label-setting"});
    const double shortest = arrived(exact) ? exact.cost : kInfinity;
    if (const double tried = shortest_by_trying(field); tried < kInfinity) {
      EXPECT_LE(shortest, tried * (1 + 1e-12));
    }
    for (const Heuristic& one : kAll) {
      const Plan plan = fly(world, {.name = one.planner, .preset = one.preset}, {.iterations = 30});
      expect_sound(site, plan, shortest, std::string(one.planner) + " " + one.preset + " " + std::to_string(seed));
      (arrived(plan) ? found : none) += 1;
      if (std::string_view(one.preset) == "improved" && shortest < kInfinity && plan.cost <= shortest * (1 + 1e-9))
        ++best_of_ga;
      if (plan.outcome == Outcome::infeasible_proven) {
        EXPECT_EQ(exact.outcome, Outcome::infeasible_proven);
      }
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(none, 30);
  EXPECT_GT(best_of_ga, 5);
}

TEST(CorrectionHeuristics, AreSoundOnLargerSets) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Site site = test::drawn_site(seed % 2 == 0 ? CorrectionLaw::set1 : CorrectionLaw::set2, 900, seed);
    const World world(site);
    const Plan exact = fly(world, {.name = "label-setting"});
    for (const Heuristic& one : kAll)
      expect_sound(site, fly(world, {.name = one.planner, .preset = one.preset}, {.iterations = 40}),
                   arrived(exact) ? exact.cost : kInfinity, one.preset);
  }
}

class ContestSets : public testing::TestWithParam<CorrectionLaw> {
 protected:
  void SetUp() override { ALATE_NEEDS_CONTEST_POINTS; }
};

TEST_P(ContestSets, ImprovedPlannersComeWithinAFewThousandthsOnEverySeed) {
  const World world(test::correction_site(test::contest_field(GetParam())));
  const double shortest = fly(world, {.name = "label-setting"}).cost;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Plan bred = fly(world, {.name = "correction-ga"}, {.seed = seed});
    const Plan walked = fly(world, {.name = "correction-aco"}, {.seed = seed});
    ASSERT_TRUE(arrived(bred) && arrived(walked));
    EXPECT_LE(bred.cost, shortest * 1.001) << seed;
    EXPECT_LE(walked.cost, shortest * 1.005) << seed;
    EXPECT_GE(std::min(bred.cost, walked.cost), shortest * (1 - 1e-12));
  }
}

TEST_P(ContestSets, SparseAstarFindsRoutesThatItsWeightsMakeLonger) {
  const World world(test::correction_site(test::contest_field(GetParam())));
  const double shortest = fly(world, {.name = "label-setting"}).cost;
  const auto length = [&](const std::string& weights) {
    return fly(world, {.name = "sparse-astar", .settings = {{.name = "weights", .text = weights}}}).cost;
  };
  EXPECT_GT(length("1"), shortest * 1.001);
  EXPECT_NEAR(length("2"), shortest, 1e-6);
  EXPECT_NEAR(length("own"), shortest, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Both, ContestSets, testing::Values(CorrectionLaw::set1, CorrectionLaw::set2),
                         [](const auto& one) { return one.param == CorrectionLaw::set1 ? "set1" : "set2"; });

TEST(CorrectionHeuristics, PreferFewerCorrections) {
  const Site site = test::drawn_site(CorrectionLaw::set1, 800, 3);
  const World world(site);
  Problem problem(world);
  const auto corrections = [&](const char* planner) {
    const Plan plan = plan_with(problem, {.name = planner});
    EXPECT_TRUE(check(site, plan.route).ok());
    return plan.route.states.size() - 2;
  };
  const std::size_t of_shortest = corrections("correction-ga");
  problem.prefer = Preference::corrections;
  const std::size_t fewest = corrections("label-setting");
  EXPECT_LT(fewest, of_shortest);
  EXPECT_EQ(corrections("correction-ga"), fewest);
  EXPECT_EQ(corrections("correction-aco"), fewest);
}

TEST(CorrectionHeuristics, AWeightOnCorrectionsTakesSomeOut) {
  const World world(test::drawn_site(CorrectionLaw::set1, 800, 3));
  const auto corrections = [&](const char* w) {
    return fly(world, {.name = "correction-ga", .settings = {{.name = "w", .text = w}}}).route.states.size() - 2;
  };
  EXPECT_LT(corrections("0.5"), corrections("1"));
  EXPECT_LE(corrections("0"), corrections("0.5"));
}

TEST(CorrectionHeuristics, SayThatARouteIsBeyondTheRange) {
  Site site = test::drawn_site(CorrectionLaw::set1, 611, 1);
  site.vehicle.range_m = (site.mission.goal - site.mission.start).norm() + 1;
  for (const char* planner : {"correction-ga", "sparse-astar", "correction-aco"}) {
    const Plan plan = fly(site, {.name = planner});
    EXPECT_EQ(plan.outcome, Outcome::none_found);
    EXPECT_TRUE(plan.route.empty());
    EXPECT_NE(plan.why.find("range"), std::string::npos) << plan.why;
  }
}

TEST(CorrectionHeuristics, GoRoundWhatMayNotBeEntered) {
  Site site = test::drawn_site(CorrectionLaw::set1, 611, 1);
  const Plan before = fly(site, {.name = "correction-ga"});
  ASSERT_TRUE(arrived(before));
  const std::size_t half = before.route.states.size() / 2;
  const Vec3 middle = (before.route.states[half - 1].position + before.route.states[half].position) / 2;
  site.scenario.objective.threat = 0;
  site.threats.push_back({.name = "core", .center = middle, .radius_m = 3000, .level = 1, .core_m = 3000});
  for (const Heuristic& one : {kAll[0], kAll[3], kAll[4], kAll[6]}) {
    const Plan plan = fly(site, {.name = one.planner, .preset = one.preset});
    ASSERT_TRUE(arrived(plan)) << one.planner;
    EXPECT_TRUE(check(site, plan.route).ok());
    EXPECT_GT(plan.cost, 0.99 * before.cost);
  }
}

TEST(CorrectionHeuristics, RefuseWhatTheyCannotHonour) {
  Site site = test::drawn_site(CorrectionLaw::set1, 50, 1);
  const auto refusal = [&](const char* planner, Preference prefer) {
    const World world(site);
    Problem problem(world);
    problem.prefer = prefer;
    return builtin_planners().find(planner)->refuses(problem);
  };
  for (const char* planner : {"correction-ga", "sparse-astar", "correction-aco"}) {
    EXPECT_EQ(refusal(planner, Preference::length), "");
    EXPECT_NE(refusal(planner, Preference::probability).find("probability"), std::string::npos);
  }
  EXPECT_NE(refusal("sparse-astar", Preference::corrections), "");
  site.navigation->turn_model = TurnModel::arc_tangent;
  for (const char* planner : {"correction-ga", "sparse-astar", "correction-aco"})
    EXPECT_NE(refusal(planner, Preference::length).find("turn_model"), std::string::npos);
}

TEST(CorrectionHeuristics, EvolutionIsToldIterationByIteration) {
  const Site site = test::drawn_site(CorrectionLaw::set1, 611, 1);
  for (const Heuristic& one : {kAll[0], kAll[1], kAll[6]}) {
    const Plan plan = fly(site, {.name = one.planner, .preset = one.preset}, {.iterations = 30});
    ASSERT_EQ(plan.history.size(), 30U);
    double before = kInfinity;
    for (const IterationStats& now : plan.history) {
      EXPECT_GE(now.arrived, 0);
      EXPECT_LE(now.arrived, 1);
      EXPECT_EQ(now.arrived > 0, now.mean.has_value());
      if (now.mean) {
        EXPECT_LE(*now.best, *now.mean * (1 + 1e-6));
        EXPECT_LE(*now.mean, *now.worst * (1 + 1e-6));
      }
      if (now.best_so_far) {
        EXPECT_LE(*now.best_so_far, before);
        before = *now.best_so_far;
      }
    }
    if (arrived(plan)) {
      EXPECT_NEAR(before, plan.cost, 1e-6 * plan.cost);
    }
  }
}

}  // namespace
}  // namespace alate
