// Correction-point scenarios on the command line: made, judged, and refused.
#include <algorithm>
#include <cmath>

#include "program.hpp"
#include "support/shared_data.hpp"

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

TEST(CorrectionExamples, ThePointsAreThoseOfTheLaw) {
  const TempFolder folder;
  const std::string out = folder.path().string();
  ASSERT_EQ(alate({"generate", "corrections", "--points", "300", "--law", "set1", "--seed", "3", "--out", out}).code,
            0);
  EXPECT_EQ(read_file(folder / "points.csv"), read_file(ALATE_SOURCE_DIR "/examples/corrections/points.csv"));
}

TEST(CorrectionExamples, EveryPreferencePassesAndIsOnTheFront) {
  for (const std::string prefer : {"length", "corrections", "probability"}) {
    const Finished done = alate({"plan", kCorrectionPoints, "--json", "--front", "--prefer", prefer});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json result = Json::parse(done.out);
    const auto is_the_route = [&](const Json& point) {
      return point.at("corrections") == result.at("metrics").at("corrections") &&
             std::abs(point.at("length_m").get<double>() - result.at("metrics").at("length_m").get<double>()) < 1e-6;
    };
    const Json& front = result.at("front");
    EXPECT_EQ(front.size(), 4U);
    const auto found = std::ranges::find_if(front, is_the_route);
    ASSERT_NE(found, front.end()) << prefer;
    EXPECT_NEAR(found->at("probability").get<double>(), result.at("metrics").at("probability").get<double>(), 1e-9);
  }
}

TEST(CorrectionExamples, ContestScenariosTakeTheirPointsFromOutside) {
  for (const std::string set : {"1", "2"}) {
    const std::string file = ALATE_SOURCE_DIR "/examples/corrections/contest-set" + set + ".yaml";
    const Finished without = alate({"check", "--scenario", file, "--points", "1"});
    EXPECT_EQ(without.code, 2);
    expect_contains(without.err, {"navigation.points: is missing", "--override navigation.points=FILE"});
  }
}

/// Routes as their authors printed them; the lengths are ours.
TEST(CorrectionExamples, PublishedRoutesOfTheContest) {
  ALATE_NEEDS_SHARED_DATA("correction-points/set1.csv");
  const auto judged = [](const std::string& set, const std::string& points) {
    const std::string data = shared_data("correction-points/set" + set + ".csv").string();
    return Json::parse(alate({"check", "--json", "--points", points, "--override", "navigation.points=" + data,
                              "--scenario", ALATE_SOURCE_DIR "/examples/corrections/contest-set" + set + ".yaml"})
                           .out);
  };
  const Json first = judged("1", "503,69,237,155,338,457,555,436");
  EXPECT_EQ(first.at("verdict").at("status"), "pass");
  EXPECT_NEAR(first.at("cost").get<double>(), 104'898, 1);
  const Json second = judged("2", "163,114,8,309,305,123,45,160,92,93,61,292");
  EXPECT_EQ(second.at("verdict").at("status"), "pass");
  EXPECT_NEAR(second.at("cost").get<double>(), 109'342, 1);
  const Json sure = judged("1", "503,294,91,607,61,250,369,566,400");
  EXPECT_EQ(sure.at("metrics").at("probability"), 1.0);
  EXPECT_EQ(judged("1", "504,295,124,76,34,12,404,595,398").at("verdict").at("status"), "fail");
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
