// What every registered planner owes on every problem that it serves.
#include <gtest/gtest.h>

#include <cctype>
#include <ctime>
#include <filesystem>
#include <map>

#include "alate/check/check.hpp"
#include "alate/data/scenario_file.hpp"
#include "space/objective.hpp"
#include "space/rotations.hpp"
#include "support/correction_sites.hpp"
#include "support/drifting_sites.hpp"
#include "support/fly.hpp"
#include "support/grid_sites.hpp"
#include "support/terrain_sites.hpp"
#include "support/voxel_sites.hpp"

namespace alate {
namespace {

using test::fly;

struct Law {
  std::string planner;
  std::string preset;
  std::string problem;
};

void PrintTo(const Law& one, std::ostream* out) { *out << one.planner << ' ' << one.preset << ' ' << one.problem; }

const std::map<std::string, Site>& problems() {
  static const std::map<std::string, Site> kProblems = [] {
    std::map<std::string, Site> all{{"open_air", test::open_air_site()},
                                    {"ridge", test::ridge_site()},
                                    {"nodes_a", test::konatowski_site(0.5, test::kLayoutA)},
                                    {"nodes_f", test::konatowski_site(0.2, test::kLayoutF)},
                                    {"corrections", test::drawn_site(CorrectionLaw::set1, 611, 1)},
                                    {"scarce_corrections", test::drawn_site(CorrectionLaw::set2, 2000, 2)},
                                    {"core_among_corrections", test::cored_site()},
                                    {"corrections_round_a_wall", test::drifting_site(false)},
                                    {"grid", test::grid_site(test::drawn_grid(30, 2))},
                                    {"hills", test::simple_site()}};
    std::mt19937_64 random(2);
    all.emplace("voxels", test::voxel_site(test::drawn_voxels({30, 20, 25}, 25, random)));
    const std::string jacksboro = ALATE_SOURCE_DIR "/examples/jacksboro/scenario.yaml";
    if (std::filesystem::exists(jacksboro)) all.emplace("jacksboro", load_site(load_scenario(jacksboro)));
    all.emplace("canyon", load_site(load_scenario(ALATE_SOURCE_DIR "/examples/worlds/canyon-wide.yaml")));
    return all;
  }();
  return kProblems;
}

std::vector<Law> served() {
  std::vector<Law> laws;
  for (const auto& [name, site] : problems()) {
    const World world(site);
    for (const PlannerEntry& entry : builtin_planners().entries())
      if (entry.refuses(Problem(world)).empty())
        for (const Preset& preset : entry.presets) laws.push_back({entry.name, preset.name, name});
  }
  return laws;
}

class PlannerLaws : public testing::TestWithParam<Law> {
 protected:
  Plan run(RunOptions options = {}, int threads = 1) const {
    return fly(world_, {.name = GetParam().planner, .preset = GetParam().preset}, std::move(options), threads);
  }

  /// The published walks seldom arrive in a few iterations, and hardly ever over terrain: no fault of the planner, but
  /// it must say so.
  static bool may_fail() {
    const std::string& preset = GetParam().preset;
    return preset.starts_with("konatowski2019") || preset.starts_with("zhou2020") || preset == "no-pheromone" ||
           is_mai2023();
  }
  bool said_that_it_failed(const Plan& plan) const {
    return may_fail() && plan.outcome == Outcome::none_found && plan.route.empty() && !plan.why.empty();
  }

  static bool is_mai2023() { return GetParam().planner == "terrain-aco" && GetParam().preset != "improved"; }

  /// Ranks routes by heights and turns as well as length.
  static bool minds_more_than_cost() {
    return GetParam().preset == "li2019" || GetParam().preset == "yin2021" || is_mai2023();
  }

  static bool arrived(const Plan& plan) {
    return plan.outcome == Outcome::feasible || plan.outcome == Outcome::optimal;
  }
  /// The shortest way at any angle touches corners, which routes only come close to.
  static double hair() { return GetParam().planner == "theta-star" ? 1e-6 : 0; }
  bool is_through_air() const { return site_.has_ground() && !site_.grid; }
  void expect_passes(const Route& route) const {
    const Verdict verdict = check(site_, route);
    EXPECT_TRUE(verdict.ok());
    for (const Violation& broken : verdict.violations)
      ADD_FAILURE() << broken.rule << " on leg " << broken.leg << ": " << broken.value << ", allowed " << broken.limit;
  }
  bool is_exact() const { return builtin_planners().find(GetParam().planner)->can_on(site_).exact; }

  World world_{problems().at(GetParam().problem)};
  const Site& site_ = world_.site();
};

void expect_same_bits(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.lower_bound, b.lower_bound);
  EXPECT_EQ(a.counters, b.counters);
  ASSERT_EQ(a.route.states.size(), b.route.states.size());
  for (std::size_t i = 0; i < a.route.states.size(); ++i)
    EXPECT_EQ(a.route.states[i].position, b.route.states[i].position) << i;
}

TEST_P(PlannerLaws, TheRouteArrivesFreeAndPassesCheck) {
  const Plan plan = run({.iterations = 3});
  if (said_that_it_failed(plan)) return;
  ASSERT_TRUE(arrived(plan)) << plan.why;
  EXPECT_EQ(plan.route.states.front().position, site_.mission.start);
  EXPECT_EQ(plan.route.states.front().leg, LegKind::start);
  EXPECT_LE((plan.route.states.back().position - site_.mission.goal).norm(), site_.mission.tolerance_m);
  for (std::size_t i = 1; i < plan.route.states.size(); ++i)
    EXPECT_TRUE(plan.route.states[i].arc || world_.is_free(plan.route.segment(i))) << i;
  expect_passes(plan.route);
}

TEST_P(PlannerLaws, TheCostIsWhatTheRouteMeasuresAndNotBelowTheBound) {
  const Plan plan = run({.iterations = 3});
  EXPECT_GT(plan.lower_bound, 0);
  if (said_that_it_failed(plan)) return;
  EXPECT_NEAR(plan.cost, measure(site_, plan.route).cost, 1e-9 * plan.cost);
  EXPECT_NEAR(plan.cost, Objective(world_).route_cost(plan.route), 1e-12 * plan.cost);
  EXPECT_GE(plan.cost, plan.lower_bound);
}

/// Through the air no planner has: a lattice's best string of moves is not it, and the planner says what it is.
TEST_P(PlannerLaws, OnlyAnExactPlannerClaimsTheOptimum) {
  const Plan plan = run({.iterations = 1});
  EXPECT_EQ(plan.outcome == Outcome::optimal, is_exact());
  EXPECT_TRUE(!is_exact() || plan.cost <= plan.lower_bound * (1 + hair()));
  const bool is_exact_elsewhere = builtin_planners().find(GetParam().planner)->can.exact;
  EXPECT_TRUE(!is_exact_elsewhere || !is_through_air() || !plan.why.empty());
}

TEST_P(PlannerLaws, ActionsReplayToTheSamePositions) {
  if (builtin_planners().find(GetParam().planner)->can.space != "attitude lattice") return;  // flies no such steps
  const Plan plan = run({.iterations = 1});
  Mat3 attitude = level_attitude(site_.mission.heading_rad);
  Vec3 position = site_.mission.start;
  for (std::size_t i = 1; i < plan.route.states.size(); ++i) {
    const RouteState& state = plan.route.states[i];
    ASSERT_TRUE(state.action);
    attitude = attitude * body_rotation(*state.action);
    position += *site_.vehicle.step_m * attitude.col(0);
    EXPECT_LT((state.position - position).norm(), 1e-9 * static_cast<double>(i) * *site_.vehicle.step_m);
  }
}

TEST_P(PlannerLaws, AnyNumberOfThreadsGivesTheSameBits) {
  const Plan one = run({.iterations = 3});
  expect_same_bits(one, run({.iterations = 3}, 2));
  expect_same_bits(one, run({.iterations = 3}, 8));
}

TEST_P(PlannerLaws, MoreIterationsAreNeverWorse) {
  if (minds_more_than_cost()) return;
  double before = kInfinity;
  for (const std::uint64_t iterations : {1U, 2U, 4U}) {
    const Plan plan = run({.iterations = iterations});
    const double cost = arrived(plan) ? plan.cost : kInfinity;
    EXPECT_LE(cost, before * (1 + 1e-12));
    EXPECT_LE(plan.counters.at("iterations"), iterations);
    EXPECT_TRUE(plan.reproducible);
    before = cost;
  }
}

TEST_P(PlannerLaws, ACancelledRunEndsAtOnceWithoutARoute) {
  std::stop_source source;
  source.request_stop();
  const Plan plan = run({.iterations = 1000000000, .stop = source.get_token()});
  EXPECT_EQ(plan.outcome, Outcome::none_found);
  EXPECT_TRUE(plan.route.empty());
  EXPECT_EQ(plan.stop, Stop::cancelled);
  EXPECT_FALSE(plan.reproducible);
  EXPECT_FALSE(plan.why.empty());
}

/// How long a planner may go on between two looks at the clock, in seconds; the thread sanitizer makes all some ten
/// times slower.
#ifdef __SANITIZE_THREAD__
constexpr double kGrace_s = 0.5;
#else
constexpr double kGrace_s = 0.1;
#endif

TEST_P(PlannerLaws, ADeadlineHoldsAndLeavesAValidBestOrNothing) {
  constexpr int kThreads = 2;
  for (const double limit_s : {0.001, 0.02, 0.1}) {
    // Processor time, as other programs may keep this one waiting.
    const std::clock_t start = std::clock();
    const Plan plan = run({.iterations = 1000000000, .time_limit_s = limit_s}, kThreads);
    const double used_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(used_s, kThreads * limit_s + kGrace_s);
    EXPECT_EQ(plan.reproducible, plan.stop == Stop::finished);
    if (plan.outcome != Outcome::none_found) expect_passes(plan.route);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PlannerLaws, testing::ValuesIn(served()), [](const auto& one) {
  std::string name = one.param.planner + "_" + one.param.preset + "_on_" + one.param.problem;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
});

}  // namespace
}  // namespace alate
