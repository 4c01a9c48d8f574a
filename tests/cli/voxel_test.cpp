// Voxel maps from end to end: the example, its files, and tasks of the benchmark.
#include "program.hpp"

namespace alate::test {

namespace {

const std::string kTown = ALATE_SOURCE_DIR "/examples/voxels/scenario.yaml";

class Voxels : public ::testing::Test {
 protected:
  TempFolder folder_;
};

TEST_F(Voxels, TheExampleIsFlownAndItsFilesAreJudged) {
  const std::string out = (folder_ / "out").string();
  const Finished done = alate({"plan", kTown, "--out", out, "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json result = Json::parse(done.out);
  EXPECT_EQ(result.at("planner"), "jps");
  EXPECT_EQ(result.at("outcome"), "optimal");
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  EXPECT_EQ(result.at("gap"), 0);
  EXPECT_EQ(result.at("ground").at("kind"), "voxels");
  EXPECT_EQ(result.at("route").front().at("z_m"), 15);
  EXPECT_NE(read_file(out + "/report.html").find("map of 30 x 20 x 12 voxels"), std::string::npos);
  for (const char* file : {"/result.json", "/route.csv"})
    EXPECT_EQ(alate({"check", out + file, "--scenario", kTown}).code, 0) << file;
}

TEST_F(Voxels, EveryPlannerThatServesFindsItsWay) {
  std::map<std::string, double> cost;
  for (const char* planner : {"jps", "astar", "theta-star"}) {
    const Finished done = alate({"plan", kTown, "--planner", planner, "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    cost[planner] = Json::parse(done.out).at("cost");
  }
  EXPECT_NEAR(cost.at("jps"), cost.at("astar"), 1e-9 * cost.at("astar"));
  EXPECT_LT(cost.at("theta-star"), cost.at("jps"));
  const Finished refused = alate({"plan", kTown, "--planner", "grid-aco"});
  EXPECT_EQ(refused.code, 2);
  expect_contains(refused.err, {"grid-aco cannot plan this", "not among voxels"});
}

TEST_F(Voxels, ALegThroughAHouseIsBroken) {
  write_file(folder_ / "r.csv", "x_m,y_m,z_m\n15,105,15\n285,85,15\n");
  const Finished done = alate({"check", (folder_ / "r.csv").string(), "--scenario", kTown, "--json"});
  EXPECT_EQ(done.code, 1) << done.err;
  const Json json = Json::parse(done.out);
  ASSERT_EQ(json.at("verdict").at("violations").size(), 1U);
  EXPECT_EQ(json.at("verdict").at("violations").at(0).at("rule"), "terrain_clearance");
}

TEST_F(Voxels, TasksOfTheBenchmark) {
  write_file(folder_ / "m.3dmap", "voxel 4 3 2\n1 1 0\n2 1 0\n1 1 1\n2 1 1\n");
  const std::string tasks = (folder_ / "m.3dmap.3dscen").string();
  write_file(tasks, "version 1\nm.3dmap\n0 2 0 3 0 0 5.00000000 1.3\n0 0 0 3 0 1 3.41421356 1\n0 0 0 1 0 0 2 1\n");
  for (const char* planner : {"jps", "astar"}) {
    const Finished done = alate({"scen", tasks, "--planner", planner, "--json"});
    ASSERT_EQ(done.code, 0) << done.err;
    const Json json = Json::parse(done.out);
    EXPECT_EQ(json.at("rows"), 3);
    EXPECT_EQ(json.at("solved"), 3);
    EXPECT_EQ(json.at("optimal"), 2);  // the third length is wrong on purpose
    EXPECT_EQ(json.at("shorter"), 1);
  }
  const Finished any_angle = alate({"scen", tasks, "--planner", "theta-star", "--json"});
  EXPECT_EQ(any_angle.code, 0) << any_angle.err;
  EXPECT_EQ(Json::parse(any_angle.out).at("solved"), 3);
  const Finished longest = alate({"scen", tasks, "--rows", "1", "--json"});
  ASSERT_EQ(longest.code, 0) << longest.err;
  EXPECT_EQ(Json::parse(longest.out).at("planner"), "jps");
  EXPECT_EQ(Json::parse(longest.out).at("optimal"), 1);
}

TEST_F(Voxels, TasksOfAnotherMapAreRefused) {
  write_file(folder_ / "m.3dmap", "voxel 4 3 2\n1 1 0\n");
  const std::string tasks = (folder_ / "m.3dmap.3dscen").string();
  write_file(tasks, "version 1\nm.3dmap\n0 2 0 1 1 0 5 1.3\n0 0 7 3 0 1 3 1\n");
  const Finished done = alate({"scen", tasks});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"m.3dmap.3dscen:3:", "[1, 1, 0] is blocked", "m.3dmap.3dscen:4:", "out of range"});
  write_file(tasks, "version 1\nother.3dmap\n0 2 0 3 0 0 5 1.3\n");
  const Finished other = alate({"scen", tasks});
  EXPECT_EQ(other.code, 2);
  expect_contains(other.err, {"another map", "other.3dmap", "no such file"});
}

TEST_F(Voxels, FaultsOfAMapAreToldAtOnce) {
  write_file(folder_ / "m.3dmap", "voxel 4 3 2\n4 0 0\n0 0\n0 0 x\n");
  write_file(folder_ / "s.yaml", "grid: {map: m.3dmap}\nstart: {cell: [0, 0, 0]}\ngoal: {cell: [3, 0, 0]}\n");
  const Finished done = alate({"plan", (folder_ / "s.yaml").string()});
  EXPECT_EQ(done.code, 2);
  expect_contains(done.err, {"m.3dmap:2:1", "m.3dmap:3:1", "too few numbers", "m.3dmap:4:5", "whole number"});
}

TEST_F(Voxels, PartedRooms) {
  write_file(folder_ / "m.3dmap", "voxel 3 1 2\n1 0 0\n1 0 1\n");
  write_file(folder_ / "s.yaml", "grid: {map: m.3dmap}\nstart: {cell: [0, 0, 0]}\ngoal: {cell: [2, 0, 0]}\n");
  for (const char* planner : {"jps", "astar", "theta-star"}) {
    const Finished done = alate({"plan", (folder_ / "s.yaml").string(), "--planner", planner, "--json"});
    EXPECT_EQ(done.code, 1) << done.err;
    EXPECT_EQ(Json::parse(done.out).at("outcome"), "infeasible_proven");
  }
}

}  // namespace

}  // namespace alate::test
