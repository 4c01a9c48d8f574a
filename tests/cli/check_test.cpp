// `alate check` on our own files: the same verdict, whichever file the route comes from.
#include "program.hpp"

namespace alate::test {

namespace {

class Check : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TempFolder>();
    planned_ = alate({"plan", kJacksboro, "--json", "--planner", "beam", "--out", folder_->path().string()});
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string file(const std::string& name) { return (*folder_ / name).string(); }

  static std::unique_ptr<TempFolder> folder_;
  static Finished planned_;
};

std::unique_ptr<TempFolder> Check::folder_;
Finished Check::planned_;

TEST_F(Check, ResultBringsItsScenario) {
  ASSERT_EQ(planned_.code, 0) << planned_.err;
  const Finished done = alate({"check", file("result.json")});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  expect_contains(done.out, {"verdict", "pass", "terrain_clearance", "threat_core", "arrival", "above mean sea level"});
}

TEST_F(Check, ResultRemembersItsOverrides) {
  const TempFolder folder;
  const Finished planned =
      alate({"plan", kJacksboro, "--override", "terrain.clearance_m=40", "--out", folder.path().string()});
  ASSERT_EQ(planned.code, 0) << planned.err;
  EXPECT_EQ(alate({"check", (folder / "result.json").string()}).code, 0);
}

TEST_F(Check, ScenarioIsFoundBesideTheResult) {
  const TempFolder folder;
  write_file(folder / "small.yaml", kSmall);
  Command plan = alate_command({"plan", "small.yaml", "--out", "."});
  plan.folder = folder.path();
  ASSERT_EQ(run(plan).code, 0);
  EXPECT_EQ(alate({"check", (folder / "result.json").string()}).code, 0);
}

TEST_F(Check, EveryFormatIsJudgedAlike) {
  for (const char* name : {"result.json", "route.csv", "route.plan", "route.waypoints", "route.kml", "route.geojson"}) {
    const Finished done = alate({"check", file(name), "--scenario", kJacksboro, "--json"});
    EXPECT_EQ(done.code, 0) << name << done.err << done.out;
    EXPECT_EQ(Json::parse(done.out).at("verdict").at("status"), "pass") << name;
  }
}

TEST_F(Check, BrokenRulesAreNamedWithTheirPlace) {
  const Finished done = alate(
      {"check", file("result.json"), "--override", "terrain.ceiling_agl_m=130", "--override", "vehicle.climb_deg=1"});
  EXPECT_EQ(done.code, 1) << done.err;
  expect_contains(done.out, {"fail", "BROKEN ceiling", "BROKEN climb", " N ", " W"});
}

TEST_F(Check, OtherFilesNeedAScenario) {
  const Finished done = alate({"check", file("route.csv")});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"--scenario", "route.csv"});
}

TEST_F(Check, BadFilesAreFaults) {
  const TempFolder folder;
  write_file(folder / "empty.json", "");
  write_file(folder / "cut.json", planned_.out.substr(0, planned_.out.size() / 2));
  for (const char* name : {"none.json", "empty.json", "cut.json"}) {
    const Finished done = alate({"check", (folder / name).string(), "--scenario", kJacksboro});
    EXPECT_EQ(done.code, 2) << name;
    EXPECT_EQ(done.out, "") << name;
    expect_contains(done.err, {name});
  }
}

TEST_F(Check, FaultsOfFileAndScenarioTogether) {
  const Finished done = alate({"check", "none.csv", "--scenario", "none.yaml", "--bogus"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"none.yaml", "none.csv", "--bogus"});
}

}  // namespace

}  // namespace alate::test
