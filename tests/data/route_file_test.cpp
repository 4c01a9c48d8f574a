#include "alate/data/route_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "alate/core/fault.hpp"
#include "alate/core/stream.hpp"
#include "data/limits.hpp"
#include "data/route_samples.hpp"
#include "support/shared_data.hpp"

namespace alate::test {
namespace {

namespace fs = std::filesystem;

class RouteFiles : public testing::Test {
 public:
  RouteFiles() { fs::create_directories(folder_); }
  ~RouteFiles() override { fs::remove_all(folder_); }

 protected:
  std::string write(const std::string& name, const std::string& text) const {
    fs::remove(folder_ / name);  // some file systems flush a file that is written over
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// All faults as text; empty if the file is read.
  std::string faults(const std::string& name, const std::string& text, const Frame& frame) const {
    try {
      load_route(write(name, text), frame);
      return "";
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) EXPECT_EQ(fault.file, path(name));
      return error.what();
    }
  }
  std::string faults(const std::string& name, const std::string& text) const { return faults(name, text, utm_); }

  Frame utm_ = Frame::utm({46.8, 9.84});

 private:
  fs::path folder_ = fs::temp_directory_path() / ("alate_route_" + std::to_string(::getpid()) + "_" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
};

void expect_holds(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "missing: " << part << "\nin: " << text;
}

TEST_F(RouteFiles, ResultKeepsKindsArcsActionsAndOrigin) {
  const RouteFile file = load_route(write("result.json", kResultSample), Frame::local());
  EXPECT_EQ(file.format, "result");
  EXPECT_EQ(file.scenario, "davos.yaml");
  EXPECT_EQ(file.overrides, std::vector<std::string>{"vehicle.range_m=9000"});
  const auto& states = file.route.states;
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states[0].leg, LegKind::start);
  EXPECT_FALSE(states[0].action);
  EXPECT_EQ(states[1].position, Vec3(0, 300, 1710));
  EXPECT_EQ(states[1].point_id, 7);
  EXPECT_DOUBLE_EQ(states[1].action.value().pitch_rad, radians(-7.5));
  EXPECT_DOUBLE_EQ(states[1].action->yaw_rad, kPi / 2);
  EXPECT_EQ(states[2].leg, LegKind::arc);
  EXPECT_DOUBLE_EQ(states[2].arc.value().angle_rad, kPi / 2);
  EXPECT_EQ(states[2].arc->center, Vec2(100, 300));
}

TEST_F(RouteFiles, PeekTellsTheOriginOfResultsOnly) {
  const RouteFile result = peek_result(write("result.json", kResultSample));
  EXPECT_EQ(result.scenario, "davos.yaml");
  EXPECT_EQ(result.overrides.size(), 1U);
  EXPECT_TRUE(result.route.empty());
  for (const auto& [name, text] : kRouteSamples) {
    if (name == "result.json") continue;
    EXPECT_TRUE(peek_result(write(name, text)).scenario.empty()) << name;
  }
  EXPECT_THROW(peek_result(path("absent.json")), InputError);
  EXPECT_THROW(peek_result(write("bad.json", R"({"schema": 1, "route": [], "scenario": 3})")), InputError);
}

TEST_F(RouteFiles, Csv) {
  const RouteFile file = load_route(write("route.csv", kCsvSample), Frame::local());
  EXPECT_EQ(file.format, "csv");
  ASSERT_EQ(file.route.states.size(), 3U);
  EXPECT_EQ(file.route.states[1].position, Vec3(0, 300.5, 1710));
  EXPECT_EQ(file.route.states[1].point_id, 7);
  EXPECT_EQ(file.route.states[2].leg, LegKind::straight);
  EXPECT_EQ(file.notes.size(), 1U);
}

TEST_F(RouteFiles, EarthFormatsGiveTheSamePlaces) {
  const Vec2 first = utm_.from_geo({46.81, 9.84}).value();
  const Vec2 second = utm_.from_geo({46.82, 9.85}).value();
  for (const std::string format : {"plan", "waypoints", "kml", "geojson"}) {
    const std::string name = "route." + format;
    const RouteFile file = load_route(write(name, kRouteSamples.at(name)), utm_);
    EXPECT_EQ(file.format, format);
    ASSERT_EQ(file.route.states.size(), 2U) << format;
    EXPECT_EQ(file.route.states[0].leg, LegKind::start);
    EXPECT_NEAR((file.route.states[0].position - Vec3(first.x(), first.y(), 1550)).norm(), 0, 1e-6) << format;
    EXPECT_NEAR((file.route.states[1].position - Vec3(second.x(), second.y(), 1800)).norm(), 0, 1e-6) << format;
  }
}

TEST_F(RouteFiles, NotesSayWhatWasPassedOver) {
  const RouteFile plan = load_route(write("route.plan", kPlanSample), utm_);
  ASSERT_EQ(plan.notes.size(), 3U);
  expect_holds(plan.notes[0], "complex item");
  expect_holds(plan.notes[1], "178");
  expect_holds(plan.notes[2], "loiter");
  const RouteFile waypoints = load_route(write("route.waypoints", kWaypointsSample), utm_);
  ASSERT_EQ(waypoints.notes.size(), 1U);
}

TEST_F(RouteFiles, ContentBeatsTheExtension) {
  EXPECT_EQ(load_route(write("mission.txt", kPlanSample), utm_).format, "plan");
  EXPECT_EQ(load_route(write("mission.plan", kWaypointsSample), utm_).format, "waypoints");
  EXPECT_EQ(load_route(write("noextension", kCsvSample), utm_).format, "csv");
  EXPECT_EQ(load_route(write("bom.json", "\xef\xbb\xbf" + kResultSample), utm_).format, "result");
}

TEST_F(RouteFiles, LatitudeAndLongitudeWinOverAnotherFrame) {
  const std::string text =
      "x_m,y_m,z_m,lat,lon\n"
      "0,0,1000,46.81,9.84\n"
      "10,0,1000,46.82,9.85\n";
  const RouteFile file = load_route(write("route.csv", text), utm_);
  EXPECT_EQ(file.route.states[0].position.head<2>(), utm_.from_geo({46.81, 9.84}).value());
  EXPECT_EQ(file.notes.size(), 1U);
  EXPECT_EQ(load_route(path("route.csv"), Frame::local()).route.states[1].position, Vec3(10, 0, 1000));
}

TEST_F(RouteFiles, FilesThatAreNoRoutes) {
  EXPECT_THROW(load_route(path("absent.plan"), utm_), InputError);
  EXPECT_THROW(load_route("/vsicurl/http://127.0.0.1/route.kml", utm_), InputError);
  EXPECT_THROW(load_route(fs::temp_directory_path().string(), utm_), InputError);
  for (const auto& [name, text] : kRouteSamples) {
    expect_holds(faults(name, ""), "empty");
    expect_holds(faults(name, " \r\n\t"), "empty");
    expect_holds(faults(name, std::string("\x7f\x45LF\0\1\2", 7)), "not a route");
    EXPECT_NE(faults(name, text.substr(0, text.size() / 2)), "") << name;
  }
  expect_holds(faults("note.md", "hello"), "not a route");
  expect_holds(faults("a.json", "{\"schema\": 1,\n \"route\": [}"), ":2:12: ");
  expect_holds(faults("a.json", "[1, 2]"), "no route");
  expect_holds(faults("a.json", "{}"), "no route");
  expect_holds(faults("a.json", R"({"schema": 1, "route": [{"x_m": 1e999}]})"), "too large");
}

TEST_F(RouteFiles, ResultFaults) {
  const auto faulty = [&](const std::string& from, const std::string& to) {
    return faults("result.json", with(kResultSample, from, to), Frame::local());
  };
  expect_holds(faulty("\"schema\": 1", "\"schema\": 2"), "schema");
  expect_holds(faulty("\"z_m\": 1710", "\"z_m\": null"), "route.1: no height");
  expect_holds(faulty("\"x_m\": 0", "\"x_m\": \"0\""), "route.0.x_m: must be a number");
  expect_holds(faulty("\"x_m\": 100", "\"x_m\": 1e12"), "route.2.x_m: out of range");
  expect_holds(faulty("\"leg\": \"straight\"", "\"leg\": \"zigzag\""), "route.1.leg");
  expect_holds(faulty("\"roll_deg\": 15, ", ""), "route.1.actions.roll_deg");
  expect_holds(faulty("\"radius_m\": 100, ", ""), "route.2.arc.radius_m");
  expect_holds(faulty("\"leg\": \"arc\"", "\"leg\": \"straight\""), "route.2.leg");
  expect_holds(faulty("\"point_id\": 7", "\"point_id\": 7.5"), "route.1.point_id");
  expect_holds(faults("result.json", R"({"schema": 1, "route": []})", Frame::local()), "no route");
}

TEST_F(RouteFiles, AllFaultsOfACsvWithTheirLines) {
  const std::string text = faults("route.csv",
                                  "kind,lat,lon,amsl_m\n"
                                  "start,46.8,9.8,nan\n"
                                  "straight,96.8,9.8,1000\n"
                                  "\n"
                                  "zigzag,46.8,9.8,1000\n"
                                  "straight,46.8,9.8\n"
                                  "straight,46.8,abc,1000\n");
  for (const char* part : {":2: amsl_m", ":3: lat: out of range", ":5: kind", ":6: wrong number", ":7: lon"}) {
    expect_holds(text, part);
  }
  expect_holds(faults("route.csv", "x_m,y_m\n0,0\n1,1\n"), "lacks the columns");
  expect_holds(faults("route.csv", "x_m,y_m,z_m,x_m\n0,0,0,0\n"), "twice");
  expect_holds(faults("route.csv", "x_m,y_m,z_m\n0,0,0\n"), "too few");
  expect_holds(faults("route.csv", "lat,lon,amsl_m\n1,1,1\n2,2,2\n", Frame::local()), "no place");
}

TEST_F(RouteFiles, PlanFaults) {
  const auto faulty = [&](const std::string& from, const std::string& to) {
    return faults("route.plan", with(kPlanSample, from, to));
  };
  expect_holds(faulty("\"version\": 1", "\"version\": 42"), "version");
  expect_holds(faulty("\"version\": 2", "\"version\": 7"), "mission.version");
  expect_holds(faulty("\"frame\": 3", "\"frame\": 10"), "mission.items.0.frame: heights above terrain");
  expect_holds(faulty("\"plannedHomePosition\": [46.8, 9.84, 1500],", ""), "no height of home");
  expect_holds(faulty("46.81, 9.84, 50", "91, 9.84, 50"), "mission.items.0.lat: out of range");
  expect_holds(faulty("46.81, 9.84, 50", "46.81, 9.84"), "seven params");
  expect_holds(faulty("9.85, 1800", "9.85, null"), "mission.items.3: no height");
  expect_holds(faulty("\"ComplexItem\"", "\"Item\""), "mission.items.2.type");
  expect_holds(faults("route.plan", R"({"fileType": "Plan", "version": 1})"), "no mission");
}

TEST_F(RouteFiles, WaypointFaults) {
  const auto faulty = [&](const std::string& from, const std::string& to) {
    return faults("route.waypoints", with(kWaypointsSample, from, to));
  };
  expect_holds(faulty("WPL 110", "WPL 120"), ":1: not a waypoint file");
  expect_holds(faulty("9.85 300 1", "9.85 300"), ":5: wrong number of columns");
  expect_holds(faulty("1550.0", "high"), ":4: height: must be a number");
  expect_holds(faulty("46.82 9.85", "46.82 190.85"), ":5: lon: out of range");
  expect_holds(faulty("3 0 3 16", "3 0 11 16"), ":5: frame: heights above terrain");
  expect_holds(faulty("3 0 3 16", "3 0 1 16"), ":5: frame: unknown frame");
}

TEST_F(RouteFiles, LineFaults) {
  const std::string second = "<Placemark><LineString><coordinates>1,1,1 2,2,2</coordinates></LineString></Placemark>";
  expect_holds(faults("a.kml", with(kKmlSample, "absolute", "relativeToGround")), "altitudeMode");
  expect_holds(faults("a.kml", with(kKmlSample, "<altitudeMode>absolute</altitudeMode>", "")), "altitudeMode");
  expect_holds(faults("a.kml", with(kKmlSample, "</Document>", second + "</Document>")), "one LineString");
  expect_holds(faults("a.kml", with(kKmlSample, "9.85,46.82", "9.85,96.82")), "coordinates.1.lat");
  expect_holds(faults("a.kml", "<html></html>"), "not valid KML");
  expect_holds(faults("a.geojson", with(kGeojsonSample, ", 1800", "")), "no height");
  expect_holds(faults("a.geojson", with(kGeojsonSample, "LineString", "Polygon")), "one LineString");
  expect_holds(faults("a.geojson", with(kGeojsonSample, "[9.85, 46.82, 1800]", "7")), "geometry.coordinates.1");
}

TEST_F(RouteFiles, Limits) {
  std::string rows = "x_m,y_m,z_m\n";
  for (std::size_t i = 0; i <= kMaxRouteStates; ++i) rows += "1,2,3\n";
  expect_holds(faults("route.csv", rows, Frame::local()), "too many positions");
  std::string wrong = "x_m,y_m,z_m\n";
  for (int i = 0; i < 1000; ++i) wrong += "1,2\n";
  expect_holds(faults("route.csv", wrong, Frame::local()), "900 more faults");
  const std::string large = write("large.plan", "{");
  fs::resize_file(large, kMaxRouteBytes + 1);
  try {
    load_route(large, utm_);
    FAIL() << "read";
  } catch (const InputError& error) {
    expect_holds(error.what(), "too large");
  }
}

TEST_F(RouteFiles, DeepNestingEndsInAFault) {
  const auto repeated = [](const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  EXPECT_NE(faults("a.json", "{\"route\": " + repeated("[", 1'000'000)), "");
  EXPECT_NE(faults("a.json", "{\"route\": " + repeated("[", 300'000) + repeated("]", 300'000) + "}"), "");
  expect_holds(faults("a.kml", "<kml>" + repeated("<Folder>", 200'000)), "nested too deeply");
}

TEST_F(RouteFiles, MutatedFilesGiveFaultsOrRoutesAndNothingElse) {
  for (const auto& [name, sample] : kRouteSamples) {
    const int rounds = name == "route.kml" ? 200 : 500;
    for (int round = 0; round < rounds; ++round) {
      Stream random(static_cast<std::uint64_t>(round), name.size(), 1);
      std::string text = sample;
      for (std::uint64_t edit = 0; edit <= random.below(4); ++edit) {
        const std::size_t at = random.below(text.size());
        const std::string token = std::vector<std::string>{"-", "0",  "null", "\"",    "}", "[",
                                                           ",", "\n", "\xff", "1e308", "<", "nan"}[random.below(12)];
        if (random.below(3) == 0)
          text.erase(at, 1 + random.below(12));
        else
          text.replace(at, random.below(3), token);
      }
      try {
        const RouteFile file = load_route(write(name, text), round % 2 == 0 ? utm_ : Frame::local());
        EXPECT_GE(file.route.states.size(), 2U);
        for (const RouteState& state : file.route.states) EXPECT_TRUE(state.position.allFinite());
        peek_result(path(name));
      } catch (const InputError& error) {
        EXPECT_FALSE(error.faults().empty());
      }
    }
  }
}

TEST(SharedMissions, GoodOnesAreReadAndFaultyOnesRefused) {
  ALATE_NEEDS_SHARED_DATA("missions");
  const std::map<std::string, std::size_t> positions{{"ardupilot/KalaupapaCanyonRun.txt", 29},
                                                     {"px4/fw_mission.plan", 5},
                                                     {"px4/multicopter_mission_geofence_avoid.plan", 4},
                                                     {"px4/vtol_mission_with_land_start.plan", 8},
                                                     {"qgc/davosdorf_mission.plan", 3},
                                                     {"qgc/qgroundcontrol_sample.plan", 4}};
  for (const auto& entry : fs::recursive_directory_iterator(shared_data("missions"))) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), shared_data("missions")).generic_string();
    SCOPED_TRACE(name);
    try {
      const RouteFile file = load_route(entry.path().string(), Frame::utm({47, 8}));
      if (positions.contains(name)) {
        EXPECT_EQ(file.route.states.size(), positions.at(name));
      }
      EXPECT_EQ(name.find("wrong_"), std::string::npos);
      EXPECT_EQ(name.find("without_mission"), std::string::npos);
    } catch (const InputError& error) {
      EXPECT_FALSE(positions.contains(name)) << error.what();
    }
  }
}

TEST(SharedMissions, HeightsAboveHomeAreRaised) {
  ALATE_NEEDS_SHARED_DATA("missions/qgc/davosdorf_mission.plan");
  const std::string file = shared_data("missions/qgc/davosdorf_mission.plan").string();
  const RouteFile mission = load_route(file, Frame::utm({46.8, 9.8}));
  EXPECT_DOUBLE_EQ(mission.route.states.front().position.z(), 1562 + 50);
}

}  // namespace
}  // namespace alate::test
