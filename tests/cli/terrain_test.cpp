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
