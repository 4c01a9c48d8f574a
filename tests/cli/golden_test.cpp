// Whole results, compared with what they were.
#include "golden.hpp"

#include "program.hpp"

namespace alate::test {

namespace {

Json result_of(const std::vector<std::string>& words, const std::string& input = "") {
  const Finished done = alate(words, input);
  EXPECT_EQ(done.code, 0) << done.err;
  return lasting(Json::parse(done.out));
}

TEST(Golden, SmallScenarioByEveryPlanner) {
  for (const std::string planner : {"greedy", "beam"}) {
    const Json result =
        result_of({"plan", "-", "--json", "--planner", planner, "--override", "goal.tolerance_m=300"}, kSmall);
    EXPECT_EQ(difference_from_golden(result, "small-" + planner), "") << planner;
  }
}

TEST(Golden, Jacksboro) {
  Json result = result_of({"plan", kJacksboro, "--json"});
  result.erase("route");  // Long; length, climb and the margins pin it down.
  EXPECT_EQ(difference_from_golden(result, "jacksboro"), "");
}

TEST(Golden, Corrections) {
  EXPECT_EQ(difference_from_golden(result_of({"plan", kCorrectionPoints, "--json", "--front"}), "corrections"), "");
}

TEST(Golden, Voxels) {
  const Json result = result_of({"plan", ALATE_SOURCE_DIR "/examples/voxels/scenario.yaml", "--json"});
  EXPECT_EQ(difference_from_golden(result, "voxels"), "");
}

TEST(Golden, ADifferenceIsFound) {
  const Json kept = Json::parse(R"({"cost": 100.0, "route": [{"x_m": 1.0}, {"x_m": 2.0}], "planner": "beam"})");
  const auto changed = [&](const char* place, const Json& value) {
    Json other = kept;
    other[Json::json_pointer(place)] = value;
    return difference(kept, other);
  };
  EXPECT_EQ(changed("/cost", 100.00000001), "");
  EXPECT_EQ(changed("/cost", 100.000001), "/cost");
  EXPECT_EQ(changed("/cost", nullptr), "/cost");
  EXPECT_EQ(changed("/route/1/x_m", 2.1), "/route/1/x_m");
  EXPECT_EQ(changed("/planner", "greedy"), "/planner/");
}

}  // namespace

}  // namespace alate::test
