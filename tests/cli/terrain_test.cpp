// Whole runs of terrain-aco: the examples, and parameters out of range.
#include "program.hpp"

namespace alate::test {

namespace {

const std::string kExamples = ALATE_SOURCE_DIR "/examples/mai2023/";

TEST(TerrainAco, ExamplesPassTheCheck) {
  for (const char* name : {"simple.yaml", "medium.yaml", "ours.yaml"}) {
    const Finished done = alate({"plan", kExamples + name, "--json"});
    ASSERT_EQ(done.code, 0) << name << done.err;
    const Json result = Json::parse(done.out);
    EXPECT_EQ(result.at("planner"), "terrain-aco");
    EXPECT_EQ(result.at("preset"), "improved");
    EXPECT_EQ(result.at("verdict").at("status"), "pass");
    EXPECT_GE(result.at("cost").get<double>(), result.at("lower_bound").get<double>());
  }
}

/// The cheapest moves, the any-angle route over the same lattice, and what each says of itself.
TEST(TerrainSearch, PlansTheExamplesAndSaysWhatTheRouteIs) {
  for (const char* name : {"simple.yaml", "ours.yaml"}) {
    double moves = 1e9;
    for (const char* planner : {"astar", "theta-star"}) {
      const Finished done = alate({"plan", kExamples + name, "--planner", planner, "--json"});
      ASSERT_EQ(done.code, 0) << name << done.err;
      const Json result = Json::parse(done.out);
      EXPECT_EQ(result.at("outcome"), "feasible");
      EXPECT_EQ(result.at("verdict").at("status"), "pass");
      expect_contains(result.at("summary").get<std::string>(), {"lattice"});
      const auto cost = result.at("cost").get<double>();
      EXPECT_GT(cost, result.at("lower_bound").get<double>());
      EXPECT_LT(cost, moves);
      moves = cost;
    }
  }
}

TEST(TerrainSearch, JumpPointsAreRefusedInPlainWords) {
  const Finished done = alate({"plan", kExamples + "simple.yaml", "--planner", "jps"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"jps cannot plan this", "each leg has a cost of its own", "take astar or theta-star"});
}

TEST(TerrainAco, ValuesOutOfRangeAreToldWithTheRange) {
  const Finished done =
      alate({"plan", kExamples + "simple.yaml", "--set", "ants=0", "--set", "iterations=0", "--set", "step_m=-1",
             "--set", "side_m=-0.5", "--set", "height_m=nan", "--set", "window_side=3", "--set", "join=none"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"ants", "1 to 100000", "iterations", "step_m", "side_m", "height_m", "window_side",
                             "1 to 2", "join", "window | any"});
}

TEST(TerrainAco, StepsTooShortForAnyMemoryAreNoCrash) {
  const Finished done = alate({"plan", kExamples + "simple.yaml", "--set", "step_m=0.001"});
  EXPECT_EQ(done.code, 1);
  expect_contains(done.out, {"take longer steps"});
}

}  // namespace

}  // namespace alate::test
