// A small flight over one hill, made by hand, to be written out.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "alate/out/result.hpp"
#include "out/route_files.hpp"
#include "out/waypoints.hpp"

namespace alate::test {

struct NoPlanner {
  Plan plan(const Problem&, RunContext&) const { return {}; }
};

inline Site hill_site() {
  Site site;
  site.scenario.file = "flights/hill.yaml";
  site.scenario.overrides = {"terrain.clearance_m=60"};
  site.frame = Frame::at_origin({46.8, 9.8});
  site.ground = PeakGround{.peaks = {{.center = {5000, 4000}, .height_m = 800, .slope_m = {1500, 1500}}},
                           .area = {.min = {0, 0}, .max = {10000, 8000}}};
  site.band = {.clearance_m = 60, .ceiling_agl_m = 500};
  site.mission = {
      .start = {1000, 1000, 150}, .heading_rad = radians(45), .goal = {9000, 7000, 200}, .tolerance_m = 100};
  site.vehicle.speed_mps = 20;
  site.threats = {{.name = "radar", .center = {4000, 6000, 0}, .radius_m = 1500, .core_m = 300}};
  return site;
}

/// Round the hill on its southern side.
inline Route hill_route() {
  Route route;
  route.states.push_back({.position = {1000, 1000, 150}, .leg = LegKind::start});
  route.states.push_back({.position = {5000, 1200, 180}, .action = AttitudeAction{.pitch_rad = radians(3)}});
  route.states.push_back({.position = {8000, 3000, 250}, .leg = LegKind::climb});
  route.states.push_back({.position = {9000, 7000, 200}, .point_id = 7});
  return route;
}

/// Everything a Result borrows, beside it.
struct Flight {
  Site site = hill_site();
  ChosenPlanner planner{.name = "beam",
                        .preset = "default",
                        .chosen_by = "auto",
                        .why = "it suits the vehicle",
                        .parameters = ParamValues({{"score", std::string("J+h")}, {"width", std::int64_t{64}}}),
                        .planner = Planner(NoPlanner{})};
  Result result{site, planner};

  Flight() = default;
  Flight(const Flight&) = delete;
  Flight& operator=(const Flight&) = delete;
  Flight(Flight&&) = delete;
  Flight& operator=(Flight&&) = delete;
  ~Flight() = default;

  void find_route() {
    Plan& plan = result.plan;
    plan.outcome = Outcome::feasible;
    plan.route = hill_route();
    plan.lower_bound = 10000;
    plan.counters = {{"candidates", 1234}};
    result.metrics = {.cost = 11050, .length_m = 11000, .climb_m = 100, .descent_m = 50, .min_clearance_m = 72.5};
    result.verdict.margins = {
        {.rule = "terrain_clearance", .margin = 12.5, .unit = "m", .leg = 1, .where = {3000, 1100, 165}}};
    result.verdict.not_checked = {{.rule = "zone", .why = "no zones were given"}};
  }
};

/// A folder of this test alone, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "alate-out-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline RouteToWrite to_write(const Flight& flight) {
  const Route& route = flight.result.plan.route;
  return {flight.result, route_points(flight.site, route), route_points(flight.site, waypoints_of(route, radians(15)))};
}

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace alate::test
