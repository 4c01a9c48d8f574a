// Whole runs of `alate plan`: results, limits, signals, threads.
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "golden.hpp"
#include "program.hpp"

namespace alate::test {

namespace {

using namespace std::chrono_literals;

TEST(Plan, SpeaksPlainWords) {
  const Finished done = alate({"plan", kJacksboro, "--planner", "beam"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  expect_contains(done.out, {"beam", "cost", "no route costs less than", "verdict", "pass", "terrain_clearance",
                             "above mean sea level", "jacksboro.tif", "not clearance to fly"});
}

TEST(Plan, JsonHoldsTheResultAndNothingElse) {
  const Finished done = alate({"plan", "-", "--json", "--seed", "7"}, kSmall);
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  const Json result = Json::parse(done.out);
  EXPECT_EQ(result.at("schema"), 1);
  EXPECT_EQ(result.at("seed"), 7);
  EXPECT_EQ(result.at("chosen_by"), "auto");
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  EXPECT_EQ(result.at("reproducible"), true);
  EXPECT_GE(result.at("cost").get<double>(), result.at("lower_bound").get<double>());
  EXPECT_EQ(result.at("route")[0].at("leg"), "start");
}

TEST(Plan, OptionBeatsScenarioBeatsChoice) {
  const std::string with_planner = kSmall + "planner: {name: greedy}\n";
  const Json scenario = Json::parse(alate({"plan", "-", "--json"}, with_planner).out);
  EXPECT_EQ(scenario.at("planner"), "greedy");
  EXPECT_EQ(scenario.at("chosen_by"), "scenario");
  const Json option = Json::parse(alate({"plan", "-", "--json", "--planner", "beam"}, with_planner).out);
  EXPECT_EQ(option.at("planner"), "beam");
  EXPECT_EQ(option.at("chosen_by"), "option");
}

TEST(Plan, WorksOnTheBoundAsLongAsAsked) {
  const auto bound = [](const char* effort) {
    const Finished done =
        alate({"plan", kJacksboro, "--planner", "interval-astar", "--iterations", "1", "--json", "--bound", effort});
    EXPECT_EQ(done.code, 0) << done.err;
    const Json result = Json::parse(done.out);
    EXPECT_EQ(result.at("parameters").at("bound"), effort);
    EXPECT_GE(result.at("cost"), result.at("lower_bound"));
    return result.at("lower_bound").get<double>();
  };
  EXPECT_GE(bound("tight"), bound("quick"));
  const Finished loose = alate({"plan", kJacksboro, "--planner", "interval-astar", "--bound", "loose"});
  EXPECT_EQ(loose.code, 2);
  expect_contains(loose.err, {"--bound", "loose", "quick | tight"});
}

TEST(Plan, OverridesTheScenario) {
  const Json far = Json::parse(alate({"plan", "-", "--json"}, kSmall).out);
  const Json near =
      Json::parse(alate({"plan", "-", "--json", "--override", "goal.position_m=[2000, 0, 100]"}, kSmall).out);
  EXPECT_LT(near.at("metrics").at("length_m"), far.at("metrics").at("length_m"));
  EXPECT_EQ(near.at("overrides").size(), 1U);
}

TEST(Plan, WritesEveryFileIntoItsFolder) {
  const TempFolder folder;
  const std::filesystem::path out = folder / "deep/out";
  const Finished done = alate({"plan", kJacksboro, "--out", out.string()});
  EXPECT_EQ(done.code, 0) << done.err;
  for (const char* name :
       {"report.html", "result.json", "route.csv", "route.plan", "route.waypoints", "route.kml", "route.geojson"}) {
    EXPECT_GT(std::filesystem::file_size(out / name), 0U) << name;
    expect_contains(done.out, {(out / name).string()});
  }
}

TEST(Plan, NoRouteIsExitOne) {
  const std::string walled =
      replaced(kSmall, "center_m: [1500, 250, 100], radius_m: 400, core_m: 100",
               "center_m: [3000, 500, 100], radius_m: 900, core_m: 0}, {name: wall, cylinder: {center_m: [1500, 250], "
               "floor_m: -90000, top_m: 90000}, radius_m: 900, core_m: 800");
  const Finished blind = alate({"plan", "-", "--json", "--planner", "greedy", "--override", "vehicle.yaw_deg=[0]",
                                "--override", "vehicle.roll_deg=[0]", "--override", "vehicle.pitch_deg=[0]"},
                               walled);
  EXPECT_EQ(blind.code, 1) << blind.err;
  const Json result = Json::parse(blind.out);
  EXPECT_TRUE(result.at("route").empty());
  EXPECT_TRUE(result.at("cost").is_null());
}

TEST(Plan, SameBitsForAnyNumberOfThreads) {
  const auto result = [](const std::string& threads) {
    return lasting(Json::parse(alate({"plan", kJacksboro, "--planner", "beam", "--json", "--threads", threads}).out));
  };
  const Json one = result("1");
  EXPECT_TRUE(one == result("2"));
  EXPECT_TRUE(one == result("8"));
}

/// How long a busy machine may need before there is a route to keep: tried in turn, the last must do.
constexpr std::array<double, 5> kPatience{0.2, 1, 4, 16, 60};

Finished plan_within(double limit_s, const std::vector<std::string>& more) {
  std::vector<std::string> words{"plan", kJacksboro, "--json", "--time-limit", std::to_string(limit_s)};
  words.insert(words.end(), more.begin(), more.end());
  Finished done = alate(words);
  EXPECT_LT(done.seconds, limit_s + 10) << done.err;
  return done;
}

TEST(Plan, TimeLimitReturnsWithTheBestSoFar) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--iterations", "1000000000"}}) {
    Finished done;
    for (const double limit_s : kPatience) {
      done = plan_within(limit_s, more);
      const Json result = Json::parse(done.out);
      EXPECT_EQ(result.at("stop"), "deadline");
      EXPECT_EQ(result.at("reproducible"), false);
      EXPECT_EQ(result.at("route").empty(), done.code == 1);
      if (done.code == 0) break;
    }
    EXPECT_EQ(done.code, 0) << done.err;
  }
}

class Interrupted : public ::testing::TestWithParam<int> {
 protected:
  /// A run that would not end by itself, sent the signal this long after it is ready for it.
  static Finished interrupt_after(double wait_s, const std::filesystem::path& out) {
    Process process(alate_command({"plan", kJacksboro, "--json", "--iterations", "1000000000", "--out", out.string()}));
    while (process.running() && !process.blocks(GetParam())) std::this_thread::sleep_for(5ms);
    std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    EXPECT_TRUE(process.running());
    process.send(GetParam());
    return process.wait(wait_s + 60);
  }
};

TEST_P(Interrupted, KeepsTheBestSoFar) {
  const TempFolder folder;
  Json result;
  for (const double wait_s : kPatience) {
    const Finished done = interrupt_after(wait_s, folder / "out");
    ASSERT_EQ(done.code, 130) << done.err;
    result = Json::parse(done.out);
    if (!result.at("route").empty()) break;
  }
  EXPECT_EQ(result.at("stop"), "cancelled");
  EXPECT_EQ(result.at("reproducible"), false);
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  EXPECT_EQ(Json::parse(read_file(folder / "out/result.json")), result);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/route.plan"));
}

TEST(Plan, ASecondSignalEndsAtOnce) {
  // Its input never comes, so it cannot stop by itself.
  const TempFolder folder;
  ASSERT_EQ(mkfifo((folder / "never").c_str(), 0600), 0);
  Process process(alate_command({"plan", (folder / "never").string()}));
  while (process.running() && !process.blocks(SIGINT)) std::this_thread::sleep_for(5ms);
  process.send(SIGINT);
  std::this_thread::sleep_for(500ms);
  ASSERT_TRUE(process.running());
  process.send(SIGINT);
  EXPECT_EQ(process.wait(60).code, 130);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, ::testing::Values(SIGINT, SIGTERM));

TEST(Plan, ThreatWithTagsInItsNameDoesNoHarm) {
  const TempFolder folder;
  const std::string name = "<script>alert(1)</script>";
  const std::string scenario = (folder / "scenario.yaml").string();
  std::string text = replaced(read_file(kJacksboro), "jacksboro.tif", kJacksboroTerrain);
  text = replaced(text, "Ridge radar", "\"" + name + "\"");
  write_file(scenario, text);
  const Finished done = alate({"plan", scenario, "--out", (folder / "out").string()});
  EXPECT_EQ(done.code, 0) << done.err;
  const std::string report = read_file(folder / "out/report.html");
  EXPECT_EQ(report.find(name), std::string::npos);
  expect_contains(report, {"&lt;script&gt;alert(1)"});
  EXPECT_EQ(read_file(folder / "out/route.kml").find(name), std::string::npos);
}

}  // namespace

}  // namespace alate::test
