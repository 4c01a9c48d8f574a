// Help, version, and every way to get the command line wrong.
#include "program.hpp"

namespace alate::test {

namespace {

TEST(Usage, TellsItsVersion) {
  const Finished done = alate({"--version"});
  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.out, "alate 0.1.0\n");
}

TEST(Usage, HelpsWithAnExampleInEveryCommand) {
  EXPECT_EQ(alate({"--help"}).code, 0);
  for (const char* command : {"plan", "check", "planners", "compare", "init", "schema"}) {
    const Finished done = alate({command, "--help"});
    EXPECT_EQ(done.code, 0) << command;
    expect_contains(done.out, {"Example:", std::string("alate ") + command});
    EXPECT_EQ(done.err, "") << command;
  }
}

TEST(Usage, AloneItPrintsHelpAndFails) {
  const Finished done = alate({});
  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(done.out, "");
  expect_contains(done.err, {"plan", "check", "planners", "init", "Exit codes"});
}

TEST(Usage, NamesTheNearestCommandAndOption) {
  const Finished command = alate({"paln", "x.yaml"});
  EXPECT_EQ(command.code, 2);
  expect_contains(command.err, {"paln: unknown command; did you mean plan?"});
  const Finished option = alate({"plan", kJacksboro, "--thread", "2"});
  EXPECT_EQ(option.code, 2);
  expect_contains(option.err, {"--thread: unknown option; did you mean --threads?", "2: unexpected argument"});
}

TEST(Usage, MissingPlacesAndValues) {
  EXPECT_EQ(alate({"plan"}).code, 2);
  expect_contains(alate({"plan"}).err, {"SCENARIO: is missing"});
  expect_contains(alate({"check"}).err, {"FILE: is missing"});
  const Finished done = alate({"plan", kJacksboro, "--threads"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"alate plan", "--threads"});
}

TEST(Usage, TellsEveryFaultOfOptionsAndScenarioAtOnce) {
  const TempFolder folder;
  write_file(folder / "file", "");
  const Finished done =
      alate({"plan", "-", "--threads", "0", "--iterations", "-5", "--time-limit", "nan", "--seed", "one", "--set",
             "width", "--planner", "baem", "--out", (folder / "file/out").string(), "--bogus"},
            replaced(kSmall, "radius_m: 400", "radius_m: -400"));
  EXPECT_EQ(done.code, 2);
  EXPECT_EQ(done.out, "");
  expect_contains(done.err, {"--threads", "got 0", "1 to 1024", "--iterations", "got -5", "--time-limit", "got nan",
                             "> 0 s", "--seed", "got one", "--set", "got width", "--planner", "baem", "--out",
                             "is not a folder", "--bogus", "threats.0.radius_m", "-400"});
}

TEST(Usage, NumbersOutOfReachAreFaults) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--threads", "0"},
                                             {"--threads", "-1"},
                                             {"--threads", "1025"},
                                             {"--threads", "2x"},
                                             {"--threads", ""},
                                             {"--iterations", "0"},
                                             {"--iterations", "-1"},
                                             {"--iterations", "1e9"},
                                             {"--iterations", "99999999999999999999"},
                                             {"--time-limit", "0"},
                                             {"--time-limit", "-0.5"},
                                             {"--time-limit", "inf"},
                                             {"--time-limit", "1,5"},
                                             {"--seed", "-1"},
                                             {"--seed", "1.5"}}) {
    const Finished done = alate({"plan", "-", words[0], words[1]}, kSmall);
    EXPECT_EQ(done.code, 2) << words[0] << ' ' << words[1];
    expect_contains(done.err, {words[0]});
  }
}

TEST(Usage, FaultsAreJsonWhenAsked) {
  const Finished done = alate({"plan", "-", "--threads", "0", "--json"}, kSmall);
  EXPECT_EQ(done.code, 2);
  const Json errors = Json::parse(done.out);
  EXPECT_EQ(errors.at("schema"), 1);
  ASSERT_EQ(errors.at("errors").size(), 1U);
  EXPECT_EQ(errors["errors"][0].at("file"), "--threads");
  EXPECT_EQ(errors["errors"][0].at("value"), "0");
  EXPECT_EQ(errors["errors"][0].at("limit"), "1 to 1024");
}

}  // namespace

}  // namespace alate::test
