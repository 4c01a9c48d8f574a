// Correction-point scenarios on the command line: made, judged, and refused.
#include "program.hpp"

namespace alate::test {

namespace {

/// Legs of 10 km along the x axis; point 2 may fail.
const std::string kCorrections =
    "navigation:\n"
    "  points:\n"
    "  - {id: 0, position_m: [0, 0, 0], kind: start}\n"
    "  - {id: 1, position_m: [10000, 0, 0], kind: vertical}\n"
    "  - {id: 2, position_m: [20000, 0, 0], kind: horizontal, may_fail: true}\n"
    "  - {id: 9, position_m: [30000, 0, 0], kind: end}\n"
    "  alpha: [25, 15]\n"
    "  beta: [20, 25]\n"
    "  theta: 21\n"
    "  residual: 12\n";

class Corrections : public ::testing::Test {
 protected:
  Corrections() { write_file(folder_ / "s.yaml", kCorrections); }

  Finished check(std::vector<std::string> words) {
    words.insert(words.begin(), {"check", "--scenario", (folder_ / "s.yaml").string()});
    return alate(std::move(words));
  }

  TempFolder folder_;
};

TEST_F(Corrections, AListOfPointsIsJudged) {
  const Finished done = check({"--points", "1,2"});
  EXPECT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"The route over 1,2, judged by", "corrections  2", "success      80.00 %",
                             "vertical_error          10.00 units", "final_error"});
}

TEST_F(Corrections, ListAsJson) {
  const Json json = Json::parse(check({"--points", "1,2", "--json"}).out);
  EXPECT_EQ(json.at("verdict").at("status"), "pass");
  EXPECT_EQ(json.at("metrics").at("corrections"), 2);
  EXPECT_NEAR(json.at("metrics").at("probability").get<double>(), 0.8, 1e-15);
  EXPECT_EQ(json.at("cost"), 30000);
}

TEST_F(Corrections, AListThatBreaksARuleIsNamed) {
  const Finished done = check({"--points", "2"});
  EXPECT_EQ(done.code, 1) << done.err;
  expect_contains(done.out, {"BROKEN final_error: 30.00 units, allowed 21.00 units, leg 2"});
}

TEST_F(Corrections, BadListsAreFaults) {
  const Finished done = check({"--points", "1,,3,x,9,-1"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err,
                  {"--points: id 2: an id is missing beside a comma",
                   "id 3: no correction point has this id (got 3, "
                   "allowed nearest ids: 2, 1)",
                   "id 4: is not the id of a point (got x, allowed 0 to 99999999)",
                   "id 5: is an end of the flight, which is not listed", "id 6: is not the id of a point (got -1"});
  expect_contains(check({"--points", ""}).err, {"--points: lists no points"});
  expect_contains(check({"file.csv", "--points", "1"}).err, {"stands in place of a file"});
  expect_contains(alate({"check", "--points", "1"}).err, {"--scenario: is missing"});
  EXPECT_EQ(alate({"check", "--points", "1"}).code, 2);
  write_file(folder_ / "small.yaml", kSmall);
  const Finished none = alate({"check", "--points", "1", "--scenario", (folder_ / "small.yaml").string()});
  EXPECT_EQ(none.code, 2);
  expect_contains(none.err, {"needs a scenario with navigation"});
}

TEST_F(Corrections, PointIdsOfRouteFilesCount) {
  const std::string rows = "leg,kind,x_m,y_m,z_m,point_id\n0,start,0,0,0,\n1,straight,10000,0,0,1\n";
  write_file(folder_ / "r.csv", rows + "2,straight,20000,0,0,2\n3,straight,30000,0,0,\n");
  EXPECT_EQ(check({(folder_ / "r.csv").string()}).code, 0);
  write_file(folder_ / "r.csv", rows + "2,straight,20000,0,0,7\n3,straight,30000,0,0,\n");
  const Finished done = check({(folder_ / "r.csv").string()});
  EXPECT_EQ(done.code, 1);
  expect_contains(done.out, {"BROKEN arrival"});
}

TEST_F(Corrections, FrontsAndPreferencesNeedNavigation) {
  const Finished done = alate({"plan", "-", "--front", "--prefer", "length"}, kSmall);
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"--front: needs a scenario with navigation", "--prefer: needs a scenario with"});
  const Finished typo = alate({"plan", "-", "--prefer", "lenght"}, kCorrections);
  EXPECT_EQ(typo.code, 2);
  expect_contains(typo.err, {"--prefer: unknown preference; did you mean length?"});
}

TEST(Generate, TheSameFieldAgainAndAgain) {
  const TempFolder folder;
  const auto generate = [&](const char* name, const char* seed) {
    const Finished done = alate({"generate", "corrections", "--points", "50", "--law", "set2", "--seed", seed, "--out",
                                 (folder / name).string()});
    EXPECT_EQ(done.code, 0) << done.err;
    return read_file(folder / name / "points.csv");
  };
  const std::string first = generate("a", "5");
  EXPECT_EQ(first, generate("b", "5"));
  EXPECT_NE(first, generate("c", "6"));
  EXPECT_EQ(std::ranges::count(first, '\n'), 53);
  const Finished judged =
      alate({"check", "--points", "1", "--scenario", (folder / "a/scenario.yaml").string(), "--json"});
  EXPECT_EQ(Json::parse(judged.out).at("metrics").at("corrections"), 1) << judged.err;
}

TEST(Generate, BadValuesAreFaultsWithLimits) {
  const Finished done =
      alate({"generate", "correction", "--points", "0", "--law", "set3", "--seed", "-1", "--out", "/dev/null/x"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"did you mean corrections?",
                             "--points: is not a whole number within its limits (got 0, "
                             "allowed 1 to 2000000)",
                             "--law: unknown law", "set1 | set2", "--seed", "--out"});
  const Finished empty = alate({"generate"});
  EXPECT_EQ(empty.code, 2);
  expect_contains(empty.err, {"WHAT: is missing", "--points: is missing", "--law: is missing", "--out: is missing"});
}

}  // namespace

}  // namespace alate::test
