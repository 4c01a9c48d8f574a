// alate compare: planners side by side, and every way to ask for it wrongly.
#include <csignal>
#include <thread>

#include "program.hpp"

namespace alate::test {

namespace {

/// A flight that turns, for interval-astar; the lattice planners lack ground and steps.
const std::string kTurning =
    "frame: {local: true}\n"
    "start: {position_m: [0, 0, 100], heading_deg: 90}\n"
    "goal: {position_m: [3000, 500, 100], tolerance_m: 100}\n"
    "vehicle: {turn_radius_m: 80}\n"
    "threats: [{name: <script>, center_m: [1500, 250, 100], radius_m: 400, core_m: 100}]\n";

std::vector<std::string> words(const std::vector<std::string>& more) {
  std::vector<std::string> all{"compare", "-", "--seconds", "0.2", "--seeds", "2", "--peers", "none"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(Compare, TellsWhoIsBestInWordsAsJsonAndAsAPage) {
  const TempFolder folder;
  const Finished done = alate(words({"--out", (folder / "out").string()}), kTurning);
  ASSERT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {" is best", "Median cost", "only ours are compared", "Cannot plan this", "label-setting",
                             "compare.html", "rows.csv", "result.json"});
  expect_contains(read_file(folder / "out/compare.html"),
                  {"<!DOCTYPE html>", "Cost against time", "Routes of interval-astar", "&lt;script&gt;"});
  EXPECT_EQ(read_file(folder / "out/compare.html").find("<script>"), std::string::npos);
  EXPECT_TRUE(
      read_file(folder / "out/rows.csv")
          .starts_with("planner,preset,peer,seed,time_s,standing,cost,length_m,climb_m,threat,took_s,broken,ending\n"
                       "interval-astar,default,false,1,0.002,"));

  const Finished json = alate(words({"--json"}), kTurning);
  ASSERT_EQ(json.code, 0) << json.err;
  const Json result = Json::parse(json.out);
  EXPECT_EQ(result["seconds"], 0.2);
  EXPECT_EQ(result["contenders"][0]["name"], "interval-astar");
  ASSERT_EQ(result["contenders"][0]["times"].size(), 5U);
  EXPECT_EQ(result["contenders"][0]["times"][4]["runs"], 2);
  EXPECT_FALSE(result["findings"].empty());
  EXPECT_FALSE(result["runs"][0]["route"].empty());
}

/// A program of others that names `peers` and runs each of them by `lines` of sh.
std::string peer_program(const TempFolder& folder, const std::string& peers, const std::string& lines) {
  const auto program = folder / "peers";
  write_file(program, "#!/bin/sh\ncat > /dev/null\n[ \"$1\" = list ] && echo '{\"peers\": [" + peers +
                          "]}' && exit 0\necho '{\"ready\": true}'\n" + lines);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return program.string();
}

Finished compare_with_peers(const std::string& program) {
  return alate({"compare", "-", "--seconds", "0.1", "--seeds", "1", "--peers", program}, kTurning);
}

TEST(Compare, NamesAPlannerWhoseRouteTheCheckRefuses) {
  const TempFolder folder;
  const std::string route =
      R"({"schema":1,"time_s":0,"route":[{"x_m":0,"y_m":0,"z_m":100,"leg":"start"},{"x_m":900,"y_m":0,"z_m":100}]})";
  const Finished done = compare_with_peers(
      peer_program(folder, R"({"name": "hasty"})", "echo '" + route + "'\necho '{\"done\": true}'\n"));
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"hasty failed in 1 of 1 runs: in 1 the check refuses the route (arrival)"});
}

TEST(Compare, SurvivesAPeerThatCrashes) {
  const TempFolder folder;
  const Finished done =
      compare_with_peers(peer_program(folder, R"({"name": "crash"}, {"name": "no", "refuses": "it will not"})",
                                      "echo 'Assertion x' >&2\nkill -ABRT $$\n"));
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"crash did not end well: aborted 1 times (signal 6", "Assertion x", "interval-astar",
                             "label-setting, ", "no."});
}

TEST(Compare, TellsEveryFaultAtOnce) {
  const TempFolder folder;
  write_file(folder / "file", "");
  const Finished done = alate({"compare", "/nowhere.yaml", "--seconds", "0", "--seeds", "0", "--peers",
                               "/nowhere/peers", "--out", (folder / "file/out").string(), "--sceonds", "1"});
  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(done.out, "");
  expect_contains(done.err, {"/nowhere.yaml", "--seconds", "got 0", "> 0, <= 86400 s", "--seeds", "1 to 10000",
                             "--peers", "--out", "is not a folder", "did you mean --seconds?"});
}

TEST(Compare, RefusesTimesThatAreNone) {
  for (const char* seconds : {"-1", "nan", "inf", "1e300", "86401", "", "one", "1s"}) {
    const Finished done = alate({"compare", "-", "--seconds", seconds}, kTurning);
    EXPECT_EQ(done.code, 2) << seconds;
    expect_contains(done.err, {"--seconds"});
  }
  for (const char* seeds : {"-1", "1.5", "10001", "99999999999999999999"}) {
    const Finished done = alate({"compare", "-", "--seeds", seeds}, kTurning);
    EXPECT_EQ(done.code, 2) << seeds;
    expect_contains(done.err, {"--seeds"});
  }
}

TEST(Compare, RefusesPlannersThatItCannotHave) {
  const Finished unknown = alate(words({"--only", "interval-aster", "--only", "jps"}), kTurning);
  EXPECT_EQ(unknown.code, 2);
  expect_contains(unknown.err, {"interval-aster", "did you mean interval-astar?", "jps", "cannot plan this: it"});
  const Finished nothing = alate(words({}), replaced(kTurning, "vehicle: {turn_radius_m: 80}\n", ""));
  EXPECT_EQ(nothing.code, 2);
  expect_contains(nothing.err, {"no planner can plan this"});
}

TEST(Compare, RefusesAFolderInUse) {
  const TempFolder folder;
  const std::string out = (folder / "out").string();
  Process first(
      alate_command({"compare", "-", "--seconds", "20", "--seeds", "1", "--peers", "none", "--out", out}, kTurning));
  while (first.running() && !std::filesystem::exists(folder / "out/.alate.lock"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const Finished second = alate(words({"--out", out}), kTurning);
  EXPECT_EQ(second.code, 2);
  expect_contains(second.err, {"--out", "another run is writing here"});
  first.send(SIGINT);
  const Finished stopped = first.wait(20);
  EXPECT_EQ(stopped.code, 130) << stopped.err;
  expect_contains(stopped.out, {"Stopped before all runs were made"});
}

}  // namespace

}  // namespace alate::test
