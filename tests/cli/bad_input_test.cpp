// Bad scenarios and terrains: exit 2, the place and field named, nothing written.
#include "program.hpp"

namespace alate::test {

namespace {

class BadInput : public ::testing::Test {
 protected:
  /// Plans `text` as bad.yaml in the test's folder and expects a refusal that names all `parts`.
  void expect_refused(const std::string& text, const std::vector<std::string>& parts) {
    write_file(folder_ / "bad.yaml", text);
    expect_refused_file((folder_ / "bad.yaml").string(), parts);
  }

  void expect_refused_file(const std::string& file, const std::vector<std::string>& parts) {
    const std::filesystem::path out = folder_ / "out";
    const Finished done = alate({"plan", file, "--out", out.string()});
    EXPECT_EQ(done.code, 2) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_FALSE(std::filesystem::exists(out));
    expect_contains(done.err, parts);
  }

  /// Jacksboro with its terrain file replaced.
  void expect_terrain_refused(const std::string& dem, const std::vector<std::string>& parts) {
    expect_refused(replaced(read_file(kJacksboro), "jacksboro.tif", dem), parts);
  }

  /// Jacksboro with one piece of text replaced, on its real terrain.
  void expect_change_refused(const std::string& from, const std::string& to, const std::vector<std::string>& parts) {
    const std::string text = replaced(read_file(kJacksboro), "jacksboro.tif", kJacksboroTerrain);
    expect_refused(replaced(text, from, to), parts);
  }

  TempFolder folder_;
};

TEST_F(BadInput, MissingScenario) { expect_refused_file((folder_ / "none.yaml").string(), {"none.yaml"}); }
TEST_F(BadInput, ScenarioIsAFolder) { expect_refused_file(folder_.path().string(), {folder_.path().string()}); }
TEST_F(BadInput, EmptyScenario) { expect_refused("", {"bad.yaml"}); }
TEST_F(BadInput, TruncatedScenario) { expect_refused(kSmall.substr(0, 80), {"bad.yaml:"}); }
TEST_F(BadInput, BinaryScenario) { expect_refused(std::string("\x00\x01\xff\xfe", 4), {"bad.yaml"}); }

TEST_F(BadInput, MissingTerrain) { expect_terrain_refused("none.tif", {"terrain.dem", "none.tif"}); }

TEST_F(BadInput, EmptyTerrain) {
  write_file(folder_ / "empty.tif", "");
  expect_terrain_refused("empty.tif", {"terrain.dem", "empty.tif"});
}

TEST_F(BadInput, TruncatedTerrain) {
  const std::string whole = read_file(kJacksboroTerrain);
  write_file(folder_ / "cut.tif", whole.substr(0, whole.size() / 2));
  expect_terrain_refused("cut.tif", {"terrain.dem", "cut.tif"});
}

TEST_F(BadInput, TerrainWithoutCoordinateSystem) {
  write_file(folder_ / "bare.asc",
             "ncols 2\nnrows 2\nxllcorner -84.5\nyllcorner 36\ncellsize 0.5\nNODATA_value -9999\n100 100\n100 100\n");
  expect_terrain_refused("bare.asc", {"terrain.dem", "bare.asc"});
}

TEST_F(BadInput, TerrainFromTheNet) {
  expect_terrain_refused("/vsicurl/http://localhost/x.tif", {"bad.yaml:7:", "terrain.dem", "/vsicurl/"});
}

TEST_F(BadInput, StartUnderGround) { expect_change_refused("agl_m: 120, heading", "agl_m: -20, heading", {"start"}); }

TEST_F(BadInput, StartUnderGroundAboveSea) {
  expect_change_refused("agl_m: 120, heading", "amsl_m: 10, heading", {"bad.yaml:11:", "start"});
}

TEST_F(BadInput, GoalOutsideTerrain) { expect_change_refused("36.2733", "37.2733", {"bad.yaml:12:", "goal"}); }

TEST_F(BadInput, NotANumber) {
  expect_refused(replaced(kSmall, "radius_m: 400", "radius_m: .nan"), {"bad.yaml:5:", "threats.0.radius_m", "nan"});
}

TEST_F(BadInput, NegativeRadius) {
  expect_refused(replaced(kSmall, "radius_m: 400", "radius_m: -400"), {"bad.yaml:5:", "threats.0.radius_m", "-400"});
}

TEST_F(BadInput, AttitudeStepsThatCannotBeFlown) {
  const std::string paper = read_file(std::string(ALATE_SOURCE_DIR) + "/examples/konatowski2019/a.yaml");
  const std::string roll = "roll_deg: [-15, -7.5, 0, 7.5, 15]";
  expect_refused(replaced(paper, roll, "roll_deg: []"), {"vehicle.roll_deg", "got 0", "allowed 1 to"});
  expect_refused(replaced(paper, roll, "roll_deg: [91]"), {"vehicle.roll_deg.0", "got 91", "-90 to 90 deg"});
  expect_refused(replaced(paper, "step_m: 2", "step_m: 0"), {"vehicle.step_m", "got 0", "allowed > 0 m"});
  expect_refused(replaced(paper, "threat: 0.5}", "threat: 0.6}"), {"fuel + threat", "got 1.1", "allowed 1"});
}

TEST_F(BadInput, UnknownKey) {
  expect_refused(replaced(kSmall, "radius_m", "radus_m"), {"bad.yaml:5:", "radus_m", "radius_m"});
}

TEST_F(BadInput, KeyTwice) {
  expect_refused(replaced(kSmall, "step_m: 200", "step_m: 200, step_m: 300"), {"bad.yaml:4:", "step_m"});
}

TEST_F(BadInput, EveryFaultOfOneFileAtOnce) {
  std::string text = replaced(kSmall, "radius_m: 400", "radius_m: -400");
  text = replaced(text, "tolerance_m: 200", "tolerance_m: -1");
  expect_refused(replaced(text, "local: true", "locl: true"),
                 {"bad.yaml:1:", "locl", "bad.yaml:3:", "goal.tolerance_m", "bad.yaml:5:", "threats.0.radius_m"});
}

TEST_F(BadInput, BadOverride) {
  const Finished done = alate({"plan", "-", "--override", "threats.0.radius_m=-1", "--override", "nothing"}, kSmall);
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"--override", "threats.0.radius_m", "nothing"});
}

TEST_F(BadInput, FolderThatCannotBe) {
  write_file(folder_ / "file", "mine");
  for (const std::string& out : {(folder_ / "file").string(), (folder_ / "file/below").string(),
                                 std::string("/proc/alate"), std::string("/dev/null")}) {
    const Finished done = alate({"plan", "-", "--out", out}, kSmall);
    EXPECT_EQ(done.code, 2) << out;
    EXPECT_EQ(done.out, "") << out;
    expect_contains(done.err, {"--out", out});
  }
  EXPECT_EQ(read_file(folder_ / "file"), "mine");
}

TEST_F(BadInput, UnknownPlannerAndParameter) {
  const Finished planner = alate({"plan", "-", "--planner", "baem"}, kSmall);
  EXPECT_EQ(planner.code, 2);
  expect_contains(planner.err, {"baem"});
  const Finished parameter = alate({"plan", "-", "--planner", "beam", "--set", "widht=3"}, kSmall);
  EXPECT_EQ(parameter.code, 2);
  expect_contains(parameter.err, {"--set", "widht"});
}

}  // namespace

}  // namespace alate::test
