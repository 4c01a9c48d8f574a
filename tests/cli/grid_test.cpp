// Scenarios on a grid: what is refused, and the check of a route made by hand.
#include <set>

#include "program.hpp"

namespace alate::test {

namespace {

const std::string kExamples = ALATE_SOURCE_DIR "/examples/yin2021/";

class GridScenario : public ::testing::Test {
 protected:
  static constexpr const char* kMap = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";

  void write(const std::string& map, const std::string& start = "[0, 2]") {
    write_file(folder_ / "m.map", map);
    write_file(folder_ / "s.yaml",
               "grid: {map: m.map, heights: peaks}\nstart: {cell: " + start + "}\ngoal: {cell: [3, 0]}\n");
  }
  Finished check(const std::string& route) {
    write_file(folder_ / "r.csv", "x_m,y_m,z_m\n" + route);
    return alate({"check", (folder_ / "r.csv").string(), "--scenario", (folder_ / "s.yaml").string(), "--json"});
  }
  void expect_refused(const std::vector<std::string>& parts) {
    const Finished done = check("0.5,0.5,0\n");
    EXPECT_EQ(done.code, 2) << done.out;
    expect_contains(done.err + done.out, parts);
  }

  TempFolder folder_;
};

TEST_F(GridScenario, RouteRoundTheBlockedCells) {
  write(kMap);
  const Finished done = check("0.5,0.5,0\n0.5,2.5,0\n3.5,2.5,0\n");
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = Json::parse(done.out);
  EXPECT_EQ(json.at("metrics").at("turns"), 1);
  EXPECT_EQ(json.at("metrics").at("length_m"), 5);
  const double deviation = json.at("metrics").at("height_dev");
  EXPECT_NEAR(json.at("metrics").at("composite").get<double>(), 5 + 100 * deviation + 1, 1e-9);
  EXPECT_EQ(json.at("ground").at("kind"), "grid");
}

TEST_F(GridScenario, RouteThatCutsACorner) {
  write(kMap);
  const Finished done = check("0.5,0.5,0\n0.5,1.5,0\n1.5,2.5,0\n3.5,2.5,0\n");
  EXPECT_EQ(done.code, 1);
  const Json violation = Json::parse(done.out).at("verdict").at("violations").at(0);
  EXPECT_EQ(violation.at("rule"), "terrain_clearance");
  EXPECT_EQ(violation.at("leg"), 2);
  EXPECT_EQ(violation.at("where").at("x_m"), 1);
}

TEST_F(GridScenario, RouteOutOfTheGrid) {
  write(kMap);
  const Finished done = check("0.5,0.5,0\n-0.5,0.5,0\n0.5,2.5,0\n3.5,2.5,0\n");
  EXPECT_EQ(done.code, 1);
  const Json json = Json::parse(done.out);
  for (const Json& violation : json.at("verdict").at("violations")) EXPECT_EQ(violation.at("rule"), "bounds");
}

TEST_F(GridScenario, MapWithFaultsTellsThemAll) {
  write("type octile\nheight 3\nwidth 4\nmap\n..x.\n.@@\n....\n");
  expect_refused({"m.map:5:3", "unknown cell", "m.map:6:4", "as long as"});
}

TEST_F(GridScenario, EmptyBinaryAndMissingMaps) {
  write("");
  expect_refused({"grid.map", "m.map", "empty"});
  write(std::string("\x7f\x45LF\0\0", 6));
  expect_refused({"m.map:1:1", "not a text file"});
  std::filesystem::remove(folder_ / "m.map");
  expect_refused({"s.yaml:1:13", "grid.map", "no such file"});
}

TEST_F(GridScenario, EndsInAWallOrOutside) {
  write(kMap, "[1, 1]");
  expect_refused({"s.yaml:2:15", "start.cell", "[1, 1]", "blocked"});
  write(kMap, "[0, 3]");
  expect_refused({"s.yaml:2:15", "start.cell", "outside the grid", "[0, 0] to [3, 2]"});
}

TEST_F(GridScenario, CutFromTerrain) {
  const std::string out = (folder_ / "out").string();
  const Finished done = alate({"plan", kExamples + "jacksboro.yaml", "--out", out, "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json result = Json::parse(done.out);
  EXPECT_EQ(result.at("verdict").at("status"), "pass");
  EXPECT_GE(result.at("metrics").at("min_clearance_m").get<double>(), 60);
  const Json& margin = result.at("verdict").at("margins").at(0);
  EXPECT_EQ(margin.at("rule"), "terrain_clearance");
  EXPECT_EQ(margin.at("unit"), "m");
  EXPECT_NEAR(margin.at("margin").get<double>() + 60, result.at("metrics").at("min_clearance_m").get<double>(), 1e-9);
  EXPECT_EQ(result.at("ground").at("terrain"), "jacksboro.tif");
  const Json& first = result.at("route").at(0);
  EXPECT_EQ(first.at("z_m"), 650);
  EXPECT_NEAR(first.at("lat").get<double>(), 36.378, 0.0006);  // half a cell
  EXPECT_NEAR(first.at("lon").get<double>(), -84.1263, 0.0006);
  // The missions are on Earth, at the flight level.
  for (const char* file : {"/route.plan", "/route.waypoints", "/route.kml", "/route.csv", "/result.json"})
    EXPECT_EQ(alate({"check", out + file, "--scenario", kExamples + "jacksboro.yaml"}).code, 0) << file;
}

TEST_F(GridScenario, CutFromTerrainIsJudgedByTheGroundAsWell) {
  const auto broken = [&](const std::string& route) {
    write_file(folder_ / "r.csv", route);
    const Finished done =
        alate({"check", (folder_ / "r.csv").string(), "--scenario", kExamples + "jacksboro.yaml", "--json"});
    EXPECT_EQ(done.code, 1) << done.err;
    std::set<std::string> units;
    const Json json = Json::parse(done.out);
    for (const Json& violation : json.at("verdict").at("violations"))
      if (violation.at("rule") == "terrain_clearance") units.insert(violation.at("unit"));
    return units;
  };
  const std::string ends = "lat,lon,amsl_m\n36.378,-84.1263,";
  // High above cells that are blocked at the flight level; low over one that is free.
  EXPECT_EQ(broken(ends + "2000\n36.2733,-84.3825,2000\n"), std::set<std::string>{"places"});
  EXPECT_EQ(broken(ends + "300\n36.379,-84.1263,300\n"), std::set<std::string>{"m"});
}

TEST_F(GridScenario, ExamplesAreSound) {
  for (const char* name : {"10x10.yaml", "30x30.yaml"}) {
    write_file(folder_ / "r.csv", "x_m,y_m,z_m\n0.5,0.5,0\n0.5,0.5,0\n");
    const Finished done = alate({"check", (folder_ / "r.csv").string(), "--scenario", kExamples + name, "--json"});
    EXPECT_EQ(done.code, 1) << done.err;
    const Json json = Json::parse(done.out);
    EXPECT_EQ(json.at("verdict").at("violations").size(), 1U);
    EXPECT_EQ(json.at("verdict").at("violations").at(0).at("rule"), "arrival");
  }
}

}  // namespace

}  // namespace alate::test
