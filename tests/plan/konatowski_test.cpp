// Figures for the threat layouts of our own; greedy walks were computed by an independent prototype.
#include <gtest/gtest.h>

#include "support/fly.hpp"

namespace alate {
namespace {

using Case = test::LayoutCase;
using test::fly;

class Konatowski : public testing::TestWithParam<Case> {};

TEST_P(Konatowski, BeamComesNearTheBestKnownAndNeverBelowTheBound) {
  const Plan plan = fly(test::konatowski_site(GetParam().fuel, GetParam().layout), {.name = "beam"});
  ASSERT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_NEAR(plan.lower_bound, GetParam().fuel * 132.608, 0.001);
  EXPECT_GE(plan.cost, plan.lower_bound);
  EXPECT_LT(plan.cost, GetParam().best_known * 1.01);
}

INSTANTIATE_TEST_SUITE_P(
    Layouts, Konatowski,
    testing::Values(Case{"A02", test::kLayoutA, 0.2, 29.28}, Case{"A05", test::kLayoutA, 0.5, 69.15},
                    Case{"A08", test::kLayoutA, 0.8, 107.60}, Case{"C02", test::kLayoutC, 0.2, 28.72},
                    Case{"C05", test::kLayoutC, 0.5, 69.71}, Case{"C08", test::kLayoutC, 0.8, 108.03},
                    Case{"F02", test::kLayoutF, 0.2, 30.61}, Case{"F05", test::kLayoutF, 0.5, 75.37},
                    Case{"F08", test::kLayoutF, 0.8, 112.17}),
    [](const auto& one) { return std::string(one.param.name); });

double greedy_cost(const std::vector<test::Sphere>& layout, const std::string& score) {
  const PlannerRequest request{.name = "greedy", .settings = {{.name = "score", .text = score, .file = "--set"}}};
  return fly(test::konatowski_site(0.5, layout), request).cost;
}

TEST(KonatowskiGreedy, WalksAsThePrototypeDid) {
  EXPECT_NEAR(greedy_cost(test::kLayoutA, "J"), 70.93, 0.01);
  EXPECT_NEAR(greedy_cost(test::kLayoutA, "J+h"), 69.32, 0.01);
  EXPECT_NEAR(greedy_cost(test::kLayoutC, "J"), 71.20, 0.01);
  EXPECT_NEAR(greedy_cost(test::kLayoutC, "J+h"), 70.03, 0.01);
}

}  // namespace
}  // namespace alate
