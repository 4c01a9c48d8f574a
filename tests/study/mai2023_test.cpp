// Scenes, fitness and its optimum, and verdicts from results made by hand.
#include <gtest/gtest.h>

#include <algorithm>

#include "alate/data/scenario_file.hpp"
#include "study/mai2023/claims.hpp"
#include "study/mai2023/fitness.hpp"
#include "study/mai2023/reproduction.hpp"
#include "study/mai2023/trail_figures.hpp"
#include "support/terrain_sites.hpp"

namespace alate::mai2023 {
namespace {

TEST(Mai2023Scenes, AreThoseOfTheExamples) {
  for (const Scene scene : kScenes) {
    const Site ours = load_site(parse_scenario(scenario_text(scene), "scene"));
    const std::string file = std::string(ALATE_SOURCE_DIR "/examples/mai2023/") + kSceneNames[scene] + ".yaml";
    const Site example = load_site(load_scenario(file));
    EXPECT_EQ(ours.mission.start, example.mission.start);
    EXPECT_EQ(ours.mission.goal, example.mission.goal);
    EXPECT_EQ(ours.band.clearance_m, example.band.clearance_m);
    EXPECT_EQ(ours.band.ceiling_amsl_m, example.band.ceiling_amsl_m);
    for (double x = 0; x <= 50'000; x += 2500)
      for (double y = 0; y <= 50'000; y += 2500)
        ASSERT_EQ(ours.ground_height({x, y}), example.ground_height({x, y})) << file << ' ' << x << ' ' << y;
  }
}

TEST(Mai2023Fitness, AddsLengthsHeightsAndTurns) {
  const Fitness fitness = fitness_of({{0, 0, 1000}, {3000, 4000, 1000}, {3000, 4000, 500}, {3000, 5000, 500}});
  EXPECT_DOUBLE_EQ(fitness.length, 5 + 0.5 + 1);
  EXPECT_DOUBLE_EQ(fitness.heights, 1 + 0.5 + 0.5);
  EXPECT_DOUBLE_EQ(fitness.turns, kPi / 2 + kPi / 2);
  EXPECT_DOUBLE_EQ(fitness.sum(), 6.5 + 2 + kPi);
}

Route route_over(const std::vector<Vec3>& places) {
  Route route;
  for (const Vec3& place : places) route.states.push_back({.position = place});
  return route;
}

TEST(Mai2023Fitness, RoutesAreCutByPlanes) {
  const std::vector<Vec3> cut = cut_by_planes(route_over({{0, 0, 0}, {2500, 0, 0}, {4000, 300, 150}}), 1000);
  ASSERT_EQ(cut.size(), 5U);
  EXPECT_EQ(cut[2], Vec3(2000, 0, 0));
  EXPECT_NEAR((cut[3] - Vec3(3000, 100, 50)).norm(), 0, 1e-9);
  EXPECT_EQ(cut[4], Vec3(4000, 300, 150));
  EXPECT_TRUE(cut_by_planes(route_over({{0, 0, 0}, {500, 0, 0}, {400, 300, 0}, {4000, 0, 0}}), 1000).empty());
  EXPECT_TRUE(cut_by_planes(Route{}, 1000).empty());
}

/// Every string of moves over four planes.
TEST(Mai2023Optimum, IsTheLeastOfAllStringsOfMoves) {
  Site site = test::simple_site();
  site.mission.start = {14000, 8000, 1000};
  site.mission.goal = {18000, 10000, 1200};
  const World world(site);
  const LatticeOptions options{
      .steps = {.main = MainDirection::x, .main_m = 1000, .side_m = 1000, .height_m = 200},
      .rules = {.limits = {.pitch_rad = radians(45), .turn_rad = radians(60)}, .any_join = true, .prunes = false},
      .score = {.rule = TerrainScore::Rule::paper}};
  Executor executor(1);
  RunContext run(executor, {});
  const TerrainLattice lattice(world, LatticeFrame(world, options.steps), options, run);
  ASSERT_EQ(lattice.walk_length(), 3U);
  double least = kInfinity;
  for (std::uint32_t a = 0; a < 25; ++a) {
    for (std::uint32_t b = 0; b < 25; ++b) {
      for (std::uint32_t c = 0; c < 25; ++c) {
        const auto flight = lattice.fly(std::vector<std::uint32_t>{a, b, c});
        if (flight) least = std::min(least, flight->cost);
      }
    }
  }
  const auto optimum = lattice_optimum(lattice);
  ASSERT_TRUE(optimum);
  EXPECT_NEAR(optimum->score, least, 1e-9);
  EXPECT_NEAR(fitness_of(optimum->places).sum(), optimum->score, 1e-5);
}

TEST(Mai2023Rules, Q0FallsJumpsAndRises) {
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 0, 500), 1);
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 100, 500), 0.8);
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 349, 500), 0.302);
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 350, 500), 0.5);
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 400, 500), 0.6);
  EXPECT_DOUBLE_EQ(scheduled_q0(1, 500, 500), 0.8);
}

/// What a run is made to tell.
struct Told {
  double fitness = 120;
  double length_km = 80;
  std::uint64_t last_change = 50;
  double time_s = 0.1;
};

void tell(Experiment& experiment, std::string_view method, const Told& told) {
  for (Trial& trial : experiment.trials) {
    if (experiment.methods[trial.method_index].name != method) continue;
    for (StudyRun& run : trial.runs) {
      const double spread = 0.01 * static_cast<double>(run.seed);
      run.passed = true;
      run.plan.history.assign(60, {.best_so_far = 2 * told.fitness});
      run.plan.history.back().best_so_far = told.fitness + spread;
      run.plan.counters = {{"last_change", told.last_change}, {"expansions", 1000}};
      run.metrics.length_m = 1000 * (told.length_km + spread);
      run.wall_s = told.time_s + 1e-4 * spread;
    }
  }
}

/// Both methods alike, under every reading.
class Mai2023Claims : public testing::Test {
 protected:
  void SetUp() override {
    tell(study_.main, kGreedy, {});
    both(kAco, {});
    both(kMai, {});
  }
  void both(const char* method, const Told& told) {
    tell(study_.main, method, told);
    for (Experiment& reading : study_.readings) tell(reading, method, told);
  }
  Claim claim(const std::string& id) const {
    const auto all = claims(study_);
    const auto found = std::ranges::find(all, id, &Claim::id);
    EXPECT_NE(found, all.end()) << id;
    return found == all.end() ? Claim{} : *found;
  }

  Study study_ = plan_study({.seeds = 9});
};

TEST_F(Mai2023Claims, OfMethodsThatAreAlike) {
  for (const char* id : {"fitness-simple", "length-medium", "iterations-simple", "time-medium"})
    EXPECT_EQ(claim(id).verdict, ClaimVerdict::does_not_hold) << id;
  EXPECT_EQ(claim("complex").verdict, ClaimVerdict::cannot_be_told);
  EXPECT_NE(claim("fitness-simple").why.find("The same under every other reading."), std::string::npos);
}

TEST_F(Mai2023Claims, FollowTheMeasures) {
  both(kMai, {.fitness = 108, .length_km = 84, .last_change = 20, .time_s = 0.09});
  EXPECT_EQ(claim("fitness-medium").verdict, ClaimVerdict::holds);
  EXPECT_NEAR(*claim("fitness-medium").ours, -10, 0.01);
  EXPECT_EQ(claim("length-medium").verdict, ClaimVerdict::does_not_hold);
  EXPECT_EQ(claim("iterations-medium").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim("iterations-medium").ours, -30);
  EXPECT_NE(claim("iterations-medium").why.find("as low after iteration 60 as ACO ends"), std::string::npos);
  EXPECT_EQ(claim("time-medium").verdict, ClaimVerdict::holds);
  EXPECT_EQ(claim("complex").verdict, ClaimVerdict::cannot_be_told) << "whatever our own scene says";
}

TEST_F(Mai2023Claims, NameReadingsWithAnotherVerdict) {
  both(kMai, {.fitness = 108});
  tell(study_.readings[1], kMai, {.fitness = 130});
  const std::string why = claim("fitness-simple").why;
  EXPECT_NE(why.find("Under other readings it does not hold with: " + readings()[2].name + "."), std::string::npos)
      << why;
}

TEST_F(Mai2023Claims, TimesMustAgreeInMeanAndLeast) {
  tell(study_.main, kMai, {.time_s = 0.2});
  for (Trial& trial : study_.main.trials)
    if (study_.main.methods[trial.method_index].name == kMai) trial.runs.front().wall_s = 0.05;
  EXPECT_EQ(claim("time-simple").verdict, ClaimVerdict::cannot_be_told);
}

TEST_F(Mai2023Claims, CannotBeToldWithoutRoutes) {
  for (Trial& trial : study_.main.trials)
    for (StudyRun& run : trial.runs) run.passed = false;
  EXPECT_EQ(claim("fitness-simple").verdict, ClaimVerdict::cannot_be_told);
  EXPECT_EQ(claim("iterations-simple").verdict, ClaimVerdict::cannot_be_told);
}

TEST(Mai2023, NothingIsShownOfAnInterruptedStudy) {
  std::stop_source source;
  source.request_stop();
  Executor executor(1);
  ReproduceOptions options{.seeds = 1, .iterations = 1};
  options.stop = source.get_token();
  EXPECT_FALSE(reproduce(executor, options));
}

}  // namespace
}  // namespace alate::mai2023
