// Ants on the attitude lattice: how good, and what bad parameters are told.
#include <gtest/gtest.h>

#include "alate/check/check.hpp"
#include "alate/core/stream.hpp"
#include "alate/data/scenario_file.hpp"
#include "space/candidates.hpp"
#include "support/fly.hpp"

namespace alate {
namespace {

using Case = test::LayoutCase;
using test::fly;

class Guided : public testing::TestWithParam<Case> {};

TEST_P(Guided, MeanIsWithinOnePercentOfTheBestKnown) {
  const World world(test::konatowski_site(GetParam().fuel, GetParam().layout));
  constexpr std::uint64_t kSeeds = 10;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Plan plan = fly(world, {.name = "attitude-aco"}, {.seed = seed});
    ASSERT_EQ(plan.outcome, Outcome::feasible);
    EXPECT_GE(plan.cost, plan.lower_bound);
    sum += plan.cost;
  }
  EXPECT_LT(sum / kSeeds, 1.01 * GetParam().best_known);
}

INSTANTIATE_TEST_SUITE_P(
    Layouts, Guided,
    testing::Values(Case{"A02", test::kLayoutA, 0.2, 29.28}, Case{"A05", test::kLayoutA, 0.5, 69.15},
                    Case{"A08", test::kLayoutA, 0.8, 107.60}, Case{"C02", test::kLayoutC, 0.2, 28.72},
                    Case{"C05", test::kLayoutC, 0.5, 69.71}, Case{"C08", test::kLayoutC, 0.8, 108.03},
                    Case{"F02", test::kLayoutF, 0.2, 30.61}, Case{"F05", test::kLayoutF, 0.5, 75.37},
                    Case{"F08", test::kLayoutF, 0.8, 112.17}),
    [](const auto& one) { return std::string(one.param.name); });

/// A layout that nothing was tuned to: spheres round the direct line.
std::vector<test::Sphere> random_layout(std::uint64_t seed) {
  Stream stream(seed, 3, 1);
  std::vector<test::Sphere> spheres;
  for (std::uint64_t left = 1 + stream.below(5); left > 0; --left) {
    const double along = stream.uniform();
    const auto aside = [&] { return 6 * (stream.uniform() - 0.5); };
    spheres.push_back(
        {7 + 13 * along + aside(), 1 + 19 * along + aside(), 5 + 5 * along + aside(), 2 + 5 * stream.uniform()});
  }
  return spheres;
}

TEST(AttitudeAco, GuidedBeatsGreedyAndThePublishedColonyOnOtherLayouts) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const double fuel : {0.2, 0.5, 0.8}) {
      const World world(test::konatowski_site(fuel, random_layout(seed)));
      const Plan guided = fly(world, {.name = "attitude-aco"});
      const Plan published = fly(world, {.name = "attitude-aco", .preset = "konatowski2019"}, {.iterations = 30});
      EXPECT_LE(guided.cost, fly(world, {.name = "greedy"}).cost);
      const double published_cost = published.outcome == Outcome::feasible ? published.cost : kInfinity;
      EXPECT_LT(guided.cost, published_cost);
    }
  }
}

TEST(AttitudeAco, ShippedLayoutsAreThoseOfTheTests) {
  const std::string folder = ALATE_SOURCE_DIR "/examples/konatowski2019/";
  for (const auto& [file, layout] :
       {std::pair{"a.yaml", test::kLayoutA}, {"c.yaml", test::kLayoutC}, {"f.yaml", test::kLayoutF}}) {
    const Plan shipped = fly(load_site(load_scenario(folder + file)), {});
    const Plan built = fly(test::konatowski_site(0.5, layout), {.name = "attitude-aco"});
    EXPECT_EQ(shipped.history.size(), built.history.size()) << file;
    EXPECT_NEAR(shipped.cost, built.cost, 1e-9 * built.cost) << file;
  }
}

TEST(AttitudeAco, PheromoneHelpsGoalDirectedWalks) {
  const World world(test::konatowski_site(0.5, test::kLayoutF));
  const auto mean = [&](const std::string& alpha) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      PlannerRequest request{.name = "attitude-aco"};
      for (const auto& [name, text] : {std::pair<std::string, std::string>{"alpha", alpha},
                                       {"ants", "50"},
                                       {"spread", "1"},
                                       {"follow", "0"},
                                       {"first_route", "none"},
                                       {"local_search", "none"}})
        request.settings.push_back({.name = name, .text = text, .file = "--set"});
      sum += fly(world, request, {.iterations = 90, .seed = seed}).cost;
    }
    return sum / 5;
  };
  EXPECT_LT(mean("1"), mean("0"));
}

PlannerRequest with(const std::string& preset, const std::string& name, const std::string& text) {
  return {.name = "attitude-aco", .preset = preset, .settings = {{.name = name, .text = text, .file = "--set"}}};
}

TEST(AttitudeAco, MoreAntsCountAtFirstWhereThoseThatFlyPastTheGoalMayEnd) {
  const World world(test::konatowski_site(0.5, test::kLayoutC));
  const auto arrived_at_first = [&](const char* overshoot) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      sum += fly(world, with("konatowski2019", "overshoot", overshoot), {.iterations = 1, .seed = seed})
                 .history.front()
                 .arrived;
    return sum / 20;
  };
  EXPECT_GT(arrived_at_first("end"), 1.5 * arrived_at_first("fly-on"));
}

TEST(AttitudeAco, AnEndThatIsNotWithinTheToleranceIsNeverTheRoute) {
  const Site site = test::konatowski_site(0.5, test::kLayoutC);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Plan plan = fly(site, with("konatowski2019", "overshoot", "end"), {.iterations = 60, .seed = seed});
    if (plan.outcome != Outcome::feasible) continue;
    EXPECT_LE((plan.route.states.back().position - site.mission.goal).norm(), site.mission.tolerance_m);
    EXPECT_DOUBLE_EQ(plan.cost, *plan.history.back().best_so_far);
  }
}

/// Exposure along the legs of a route.
double exposed(const World& world, const Plan& plan) {
  double sum = 0;
  for (std::size_t i = 1; i < plan.route.states.size(); ++i) sum += world.exposure(plan.route.segment(i));
  return sum;
}

TEST(AttitudeAco, ThreatsAtLegsSeeASphereThatNodesJumpOver) {
  const Plan straight = fly(test::konatowski_site(0.5, {}), {.name = "attitude-aco"});
  const Segment leg = straight.route.segment(4);
  const Vec3 middle = (leg.a + leg.b) / 2;
  Site site = test::konatowski_site(0.5, {{middle.x(), middle.y(), middle.z(), 0.9}});
  site.threats.front().level = 50;
  const World world(site);
  const Plan nodes = fly(world, {.name = "attitude-aco"});
  const Plan legs = fly(world, with("", "threats_at", "legs"));
  EXPECT_NEAR(nodes.cost, straight.cost, 1e-9);  // it is not seen
  EXPECT_GT(exposed(world, nodes), 10);
  EXPECT_LT(exposed(world, legs), 1);
  EXPECT_NEAR(legs.cost, measure(site, legs.route).cost, 1e-9 * legs.cost);  // as reported, not as minimised
}

TEST(AttitudeAco, HistoryTellsOfEveryIteration) {
  const Plan plan = fly(test::konatowski_site(0.5, test::kLayoutC), {.name = "attitude-aco"}, {.iterations = 12});
  ASSERT_EQ(plan.history.size(), 12U - 3U);  // three are passes of beam search for the first route
  EXPECT_NEAR(*plan.history.back().best_so_far, plan.cost, 1e-9);
  EXPECT_GT(plan.history.back().known, 0);
}

TEST(AttitudeAco, AStartAtTheGoalIsARouteOfNoLegs) {
  Site site = test::konatowski_site(0.5, test::kLayoutA);
  site.mission.goal = site.mission.start;
  const Plan plan = fly(site, {.name = "attitude-aco"});
  EXPECT_EQ(plan.outcome, Outcome::feasible);
  EXPECT_EQ(plan.route.states.size(), 1U);
  EXPECT_EQ(plan.cost, 0);
}

TEST(AttitudeAco, ThousandsOfIterationsKeepTrailsFinite) {
  const Site site = test::konatowski_site(0.5, test::kLayoutA);
  for (const char* preset : {"guided", "acs"}) {
    const Plan plan = fly(site, {.name = "attitude-aco", .preset = preset}, {.iterations = 1500});
    EXPECT_LT(plan.cost, 69.15 * 1.02) << preset;
    EXPECT_GT(plan.history.back().arrived, 0) << preset;
  }
}

Fault fault_of(const std::string& name, const std::string& text) {
  try {
    fly(test::konatowski_site(0.5, test::kLayoutA),
        {.name = "attitude-aco", .settings = {{.name = name, .text = text, .file = "--set"}}});
  } catch (const InputError& error) {
    return error.faults().front();
  }
  return {};
}

TEST(AttitudeAco, ParametersOutOfRangeAreFaultsWithTheLimit) {
  EXPECT_EQ(fault_of("ants", "0").limit, "1 to 100000");
  EXPECT_EQ(fault_of("evaporation", "0").limit, "> 0, <= 1");
  EXPECT_EQ(fault_of("evaporation", "1.01").limit, "> 0, <= 1");
  EXPECT_EQ(fault_of("trail_cell", "0").limit, "> 0, <= 100");
  EXPECT_EQ(fault_of("trail_cell", "0").unit, "steps");
  EXPECT_EQ(fault_of("temperature", "0").limit, "> 0, <= 1000000");
  EXPECT_EQ(fault_of("q", "-1").limit, "> 0, <= 1000000000000");
  EXPECT_EQ(fault_of("evaporation", "1").limit, "");
}

}  // namespace
}  // namespace alate
