// alate generate terrain on the command line.
#include "program.hpp"

namespace alate::test {

namespace {

std::vector<std::string> terrain(const std::string& law, const std::string& seed, const std::string& folder) {
  return {"generate", "terrain", "--law", law, "--side", "201", "--seed", seed, "--out", folder};
}

TEST(GenerateTerrain, CanBeFlownAtOnce) {
  const TempFolder folder;
  for (const std::string law : {"canyon", "hills"}) {
    const std::string out = (folder / law).string();
    const Finished made = alate(terrain(law, "2", out));
    ASSERT_EQ(made.code, 0) << made.err;
    expect_contains(made.out, {"terrain.tif", "Next: alate plan"});
    const Finished flown =
        alate({"plan", out + "/scenario.yaml", "--planner", "interval-astar", "--iterations", "3", "--json"});
    ASSERT_EQ(flown.code, 0) << flown.err;
    EXPECT_EQ(Json::parse(flown.out).at("verdict").at("status"), "pass") << law;
  }
}

TEST(GenerateTerrain, TheSameGroundAgainAndAgain) {
  const TempFolder folder;
  const auto make = [&](const char* name, const char* seed) {
    EXPECT_EQ(alate(terrain("canyon", seed, (folder / name).string())).code, 0);
    return read_file(folder / name / "terrain.tif");
  };
  const std::string first = make("a", "5");
  EXPECT_EQ(first, make("b", "5"));
  EXPECT_NE(first, make("c", "6"));
}

TEST(GenerateTerrain, BadValuesAreFaultsWithLimits) {
  const Finished done = alate({"generate", "terrain", "--law", "canyons", "--side", "99", "--points", "7"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"--law: unknown law; did you mean canyon?", "allowed 100 to 12000",
                             "--points: has no meaning for terrain", "--out: is missing"});
  const Finished points =
      alate({"generate", "corrections", "--law", "set1", "--points", "7", "--side", "200", "--out", "x"});
  EXPECT_EQ(points.code, 2);
  expect_contains(points.err, {"--side: has no meaning for corrections"});
}

}  // namespace

}  // namespace alate::test
