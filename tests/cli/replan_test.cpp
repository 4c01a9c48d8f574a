// Whole runs of `alate replan`.
#include "golden.hpp"
#include "program.hpp"

namespace alate::test {

namespace {

class Replan : public ::testing::Test {
 protected:
  /// Jacksboro, planned quickly; made once.
  static std::string flight() {
    static const TempFolder kFolder;
    static const std::string kFile = [] {
      const std::string out = (kFolder / "flight").string();
      const Finished done =
          alate({"plan", kJacksboro, "--planner", "interval-astar", "--iterations", "3", "--out", out});
      EXPECT_EQ(done.code, 0) << done.err;
      return out + "/result.json";
    }();
    return kFile;
  }

  static Finished replan(std::vector<std::string> more) {
    std::vector<std::string> words{"replan", kJacksboro, "--from", flight(), "--iterations", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return alate(words);
  }

  static void expect_refused(const std::vector<std::string>& words, const std::vector<std::string>& parts) {
    const Finished done = alate(words);
    EXPECT_EQ(done.code, 2) << done.err;
    EXPECT_EQ(done.out, "");
    expect_contains(done.err, parts);
  }

  TempFolder folder_;
};

TEST_F(Replan, SaysWhatIsLeftOfTheOldRoute) {
  const Finished done = replan({"--at-s", "200"});
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"4.0 km of the old", "still keep every rule", "interval-astar", "pass"});
}

/// The result stands for itself: `check` needs nothing but it.
TEST_F(Replan, WritesWhatCheckJudgesAgain) {
  const std::string out = (folder_ / "out").string();
  const Finished done = replan({"--at-s", "200", "--override", "threats.0.core_m=1700", "--out", out, "--json"});
  EXPECT_EQ(done.code, 0) << done.err;
  const Json result = Json::parse(done.out);
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  expect_contains(result.at("summary").get<std::string>(), {"4.0 km of the old"});
  for (const char* name : {"report.html", "result.json", "route.csv", "route.plan", "route.waypoints", "route.kml"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / name)) << name;
  const Finished judged = alate({"check", out + "/result.json", "--json"});
  EXPECT_EQ(judged.code, 0) << judged.err;
  EXPECT_EQ(Json::parse(judged.out).at("metrics").at("length_m"), result.at("metrics").at("length_m"));
}

TEST_F(Replan, IsWhatItWas) {
  const Finished done =
      replan({"--at-s", "200", "--json", "--override",
              "threats.3={name: new, lat: 36.300, lon: -84.235, agl_m: 0, radius_m: 900, core_m: 600}"});
  EXPECT_EQ(done.code, 0) << done.err;
  Json result = lasting(Json::parse(done.out));
  expect_contains(result.at("summary").get<std::string>(), {"now break threat_core"});
  for (const char* key : {"route", "overrides"}) result.erase(key);  // Long; and numbers as text.
  EXPECT_EQ(difference_from_golden(result, "replan"), "");
}

TEST_F(Replan, GoesOnFromAReplannedFlight) {
  const std::string out = (folder_ / "out").string();
  ASSERT_EQ(replan({"--at-s", "100", "--out", out}).code, 0);
  const Finished again = alate({"replan", kJacksboro, "--from", out + "/result.json", "--at-s", "100", "--json",
                                "--iterations", "2", "--override", "goal.tolerance_m=400"});
  EXPECT_EQ(again.code, 0) << again.err;
  const Json result = Json::parse(again.out);
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  EXPECT_EQ(result.at("overrides").back(), "vehicle.range_m=56000");
}

TEST_F(Replan, SameBitsForAnyNumberOfThreads) {
  const auto cost = [](const std::string& threads) {
    return Json::parse(replan({"--at-s", "300", "--json", "--threads", threads}).out).at("cost");
  };
  EXPECT_EQ(cost("1"), cost("4"));
}

TEST_F(Replan, RefusesTimesThatAreNone) {
  for (const std::string at : {"-1", "nan", "inf", "soon", "1e400", ""})
    expect_refused({"replan", kJacksboro, "--from", flight(), "--at-s=" + at}, {"--at-s"});
  expect_refused({"replan", kJacksboro, "--from", flight(), "--at-s", "99999"}, {"--at-s", "the flight is over"});
}

TEST_F(Replan, NamesTheAircraftThatIsAboveTheNewCeiling) {
  expect_refused({"replan", kJacksboro, "--from", flight(), "--at-s", "400", "--override", "terrain.ceiling_agl_m=62"},
                 {"--at-s 400: the aircraft by then: is above the ceiling", "goal: is above the ceiling"});
}

TEST_F(Replan, RefusesWhatIsNoFlightOfTheScenario) {
  expect_refused({"replan", kCorrectionPoints, "--from", flight(), "--at-s", "10"}, {"another scenario"});
  write_file(folder_ / "cut.json", read_file(flight()).substr(0, 500));
  expect_refused({"replan", kJacksboro, "--from", (folder_ / "cut.json").string(), "--at-s", "10"}, {"cut.json"});
  write_file(folder_ / "none.json", R"({"schema": 1, "route": []})");
  expect_refused({"replan", kJacksboro, "--from", (folder_ / "none.json").string(), "--at-s", "10"}, {"no route"});
  expect_refused({"replan", kJacksboro, "--from", "/nowhere.json", "--at-s", "10"}, {"/nowhere.json"});
}

TEST_F(Replan, TellsEveryFaultAtOnce) {
  expect_refused({"replan", kJacksboro, "--from", "/nowhere.json", "--at-s", "-3", "--seed", "x", "--override",
                  "start.heading_deg=3"},
                 {"/nowhere.json", "--at-s", "--seed", "start of a flight under way"});
  expect_refused({"replan"}, {"SCENARIO", "--from", "--at-s"});
}

TEST_F(Replan, NeedsASpeed) {
  const std::string text = replaced(read_file(kJacksboro), "jacksboro.tif", kJacksboroTerrain);
  const std::string scenario = (folder_ / "slow.yaml").string();
  write_file(scenario, replaced(text, "  speed_mps: 20\n", ""));
  expect_refused({"replan", scenario, "--from", flight(), "--at-s", "10"}, {"vehicle.speed_mps", "needed"});
}

/// The aircraft is too low already.
TEST_F(Replan, RefusesAStateThatIsLost) {
  expect_refused({"replan", kJacksboro, "--from", flight(), "--at-s", "300", "--override", "terrain.clearance_m=190"},
                 {"the aircraft by then", "clearance"});
}

}  // namespace

}  // namespace alate::test
