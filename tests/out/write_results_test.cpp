#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "out/output_folder.hpp"
#include "support.hpp"

namespace alate {
namespace {

namespace fs = std::filesystem;
using test::Flight;
using test::TemporaryFolder;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

bool has_warning(const Result& result, const std::string& part) {
  return std::ranges::any_of(result.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

std::string message_of(const std::string& folder, Result& result) {
  try {
    write_results(folder, result);
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().at(0).field, "--out");
    return error.what();
  }
  return "no fault";
}

TEST(WriteResults, WritesEveryFileAndNothingElse) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "deep" / "out";
  Flight flight;
  flight.find_route();
  write_results(out, flight.result);
  const std::set<std::string> all{"result.json", "report.html", "route.csv",      "route.geojson",
                                  "route.kml",   "route.plan",  "route.waypoints"};
  EXPECT_EQ(names_in(out), all);
  EXPECT_EQ(std::set<std::string>(flight.result.files.begin(), flight.result.files.end()), all);
  const auto json = nlohmann::json::parse(test::read_text(out / "result.json"));
  EXPECT_EQ(json["files"].size(), all.size());
  EXPECT_TRUE(has_warning(flight.result, "after the last waypoint"));
}

TEST(WriteResults, LeavesOutWhatNeedsAPlaceOnEarth) {
  const TemporaryFolder folder;
  Flight flight;
  flight.find_route();
  flight.site.frame = Frame::local();
  write_results(folder.path(), flight.result);
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"result.json", "report.html", "route.csv"}));
  EXPECT_TRUE(has_warning(flight.result, "route.geojson, route.kml, route.plan, route.waypoints left out"));
}

TEST(WriteResults, GivesNoMissionOfARouteThatDidNotPass) {
  const TemporaryFolder folder;
  for (const Status status : {Status::fail, Status::unknown}) {
    Flight flight;
    flight.find_route();
    flight.result.verdict.status = status;
    write_results(folder.path(), flight.result);
    EXPECT_FALSE(names_in(folder.path()).contains("route.plan"));
    EXPECT_FALSE(names_in(folder.path()).contains("route.waypoints"));
    EXPECT_TRUE(names_in(folder.path()).contains("route.kml"));
    EXPECT_TRUE(has_warning(flight.result, "did not pass"));
  }
}

TEST(WriteResults, RemovesAnEarlierRouteAndTouchesNothingElse) {
  const TemporaryFolder folder;
  Flight found;
  found.find_route();
  write_results(folder.path(), found.result);
  test::write_text(folder.path() / "mine.txt", "keep");
  Flight none;
  write_results(folder.path(), none.result);
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"result.json", "report.html", "mine.txt"}));
  EXPECT_EQ(test::read_text(folder.path() / "mine.txt"), "keep");
}

TEST(WriteResults, WarnsOfMissionsThatAutopilotsCannotStore) {
  const TemporaryFolder folder;
  Flight flight;
  flight.find_route();
  auto& states = flight.result.plan.route.states;
  while (states.size() < 699) states.push_back(states.back());
  write_results(folder.path(), flight.result);
  EXPECT_TRUE(has_warning(flight.result, "701 items"));
}

TEST(WriteResults, RefusesAFolderThatAnotherRunHolds) {
  const TemporaryFolder folder;
  Flight flight;
  {
    const OutputFolder other(folder.path());
    EXPECT_NE(message_of(folder.path(), flight.result).find("another run is writing here"), std::string::npos);
  }
  EXPECT_EQ(message_of(folder.path(), flight.result), "no fault");
}

TEST(WriteResults, TakesOverALockThatNobodyHolds) {
  const TemporaryFolder folder;
  test::write_text(folder.path() / ".alate.lock", "");
  Flight flight;
  EXPECT_EQ(message_of(folder.path(), flight.result), "no fault");
  EXPECT_FALSE(names_in(folder.path()).contains(".alate.lock"));
}

TEST(WriteResults, NamesAFolderThatIsAFile) {
  const TemporaryFolder folder;
  test::write_text(folder.path() / "file", "");
  Flight flight;
  EXPECT_NE(message_of(folder.path() / "file", flight.result).find("--out"), std::string::npos);
  EXPECT_NE(message_of(folder.path() / "file" / "below", flight.result).find("--out"), std::string::npos);
  EXPECT_NE(message_of("/proc/alate", flight.result).find("--out"), std::string::npos);
}

TEST(WriteResults, LeavesNothingHalfWrittenBehindAFault) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "result.json");
  Flight flight;
  EXPECT_NE(message_of(folder.path(), flight.result).find("result.json"), std::string::npos);
  for (const std::string& name : names_in(folder.path())) EXPECT_FALSE(name.starts_with(".")) << name;
}

TEST(WriteResultsDeathTest, ReportsAFullDisk) {
  const TemporaryFolder folder;
  const auto write_beyond_limit = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      Flight flight;
      write_results(folder.path(), flight.result);
    } catch (const std::system_error& error) {
      std::_Exit(names_in(folder.path()).empty() && error.code() == std::errc::file_too_large ? 42 : 1);
    }
    std::_Exit(2);
  };
  EXPECT_EXIT(write_beyond_limit(), testing::ExitedWithCode(42), "");
}

}  // namespace
}  // namespace alate
