// alate scen and the exact planners on a small map.
#include <cmath>

#include "program.hpp"

namespace alate::test {

namespace {

class Scen : public ::testing::Test {
 protected:
  Scen() {
    write_file(folder_ / "m.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
    write_file(folder_ / "m.map.scen",
               "version 1\n0\tm.map\t4\t3\t0\t2\t3\t0\t5\n0\tm.map\t4\t3\t0\t0\t1\t0\t1\n"
               "0\tm.map\t4\t3\t0\t0\t3\t0\t4\n");
  }
  Finished scen(std::vector<std::string> more) {
    more.insert(more.begin(), {"scen", (folder_ / "m.map.scen").string()});
    return alate(more);
  }

  TempFolder folder_;
};

TEST_F(Scen, CountsWhatIsSolvedAndOptimal) {
  for (const char* planner : {"jps", "astar"}) {
    const Finished done = scen({"--planner", planner, "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json json = Json::parse(done.out);
    EXPECT_EQ(json.at("rows"), 3);
    EXPECT_EQ(json.at("solved"), 3);
    EXPECT_EQ(json.at("optimal"), 2);  // the third length is wrong on purpose
    EXPECT_EQ(json.at("shorter"), 1);
    EXPECT_NEAR(json.at("mean_gap").get<double>(), -0.25 / 3, 1e-12);
    EXPECT_GE(json.at("p99_s").get<double>(), json.at("mean_s").get<double>());
  }
}

TEST_F(Scen, LegsAtAnyAngleAreShorterThanPublished) {
  const Finished done = scen({"--planner", "theta-star", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json.at("solved"), 3);
  EXPECT_EQ(json.at("optimal"), 1);
  EXPECT_EQ(json.at("shorter"), 2);
  const double round_the_wall = std::hypot(0.5, 1.5) + std::hypot(2.5, 0.5);
  EXPECT_NEAR(json.at("mean_gap").get<double>(), (round_the_wall / 5 - 1 - 0.25) / 3, 1e-5);
  expect_contains(scen({"--planner", "theta-star"}).out, {"theta-star (default)", "shorter   2, as the published"});
}

TEST_F(Scen, TakesTheLongestRows) {
  const Finished done = scen({"--rows", "1", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json.at("rows"), 1);
  EXPECT_EQ(json.at("optimal"), 1);
  EXPECT_EQ(json.at("planner"), "jps");
}

TEST_F(Scen, ServesColoniesWithTheirPresets) {
  const Finished done = scen({"--planner", "grid-aco", "--preset", "mmas", "--rows", "2"});
  ASSERT_EQ(done.code, 0) << done.err;
  expect_contains(done.out, {"grid-aco (mmas)", "rows      2", "solved    2", "planning alone"});
}

TEST_F(Scen, FaultsAreToldAtOnce) {
  write_file(folder_ / "m.map.scen", "version 1\n0\tm.map\t5\t3\t0\t2\t3\t0\t5\n0\tm.map\t4\t3\t1\t1\t3\t9\t5\n");
  const Finished done = scen({"--planner", "jsp"});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err,
                  {":2:", "is not that of the map", ":3:", "blocked", "out of range", "unknown planner", "astar"});
  EXPECT_EQ(scen({"--rows", "0"}).code, 2);
}

TEST_F(Scen, PlansOnAPlainGridBySearchUnlessToldOtherwise) {
  write_file(folder_ / "s.yaml", "grid: {map: m.map}\nstart: {cell: [0, 2]}\ngoal: {cell: [3, 0]}\n");
  const Finished done = alate({"plan", (folder_ / "s.yaml").string(), "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json.at("planner"), "jps");
  EXPECT_EQ(json.at("outcome"), "optimal");
  EXPECT_EQ(json.at("cost"), 5);
  EXPECT_EQ(json.at("lower_bound"), 5);
  expect_contains(json.at("why"), {"exact search"});
}

TEST_F(Scen, Parted) {
  write_file(folder_ / "m.map", "type octile\nheight 3\nwidth 4\nmap\n..@.\n..@.\n..@.\n");
  write_file(folder_ / "s.yaml", "grid: {map: m.map}\nstart: {cell: [0, 2]}\ngoal: {cell: [3, 0]}\n");
  for (const char* planner : {"jps", "astar", "theta-star"}) {
    const Finished done = alate({"plan", (folder_ / "s.yaml").string(), "--planner", planner});
    EXPECT_EQ(done.code, 1) << done.err;
    expect_contains(done.out, {"blocked cells part the start from the goal", "[1, 0]"});
  }
}

}  // namespace

}  // namespace alate::test
