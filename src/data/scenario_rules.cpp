#include "data/scenario_rules.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "data/limits.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

class Rules {
 public:
  Rules(const Scenario& scenario, std::vector<Fault>& faults) : scenario_(scenario), faults_(faults) {
    for (const Fault& fault : faults) {
      faulty_.insert(fault.field);
      if (fault.field == "frame" || fault.field.starts_with("frame.")) frame_sound_ = false;
    }
  }

  void check_terrain();
  void check_grid();
  void check_places();
  void check_vehicle();
  void check_threats();
  void check_objective();
  void check_navigation();

 private:
  bool given(const std::string& path) const { return scenario_.marks.contains(path); }
  /// Was it read without a fault, and all around it?
  bool sound(std::string path) const {
    for (std::size_t dot = path.size(); dot != std::string::npos; dot = path.rfind('.')) {
      path.resize(dot);
      if (faulty_.contains(path)) return false;
    }
    return true;
  }
  void report(const std::string& path, Fault fault) {
    const Mark mark = mark_of(scenario_, path);
    fault.file = mark.file;
    fault.line = mark.line;
    fault.column = mark.column;
    fault.field = path;
    faults_.push_back(std::move(fault));
  }
  /// Is there a grid that is cut from a raster?
  bool is_cut() const { return scenario_.grid && given("grid.dem"); }
  void check_cut_grid();
  void check_cell(const std::string& path);
  void check_place(const std::string& path);
  void check_ground_frame(const std::string& path, bool geographic);
  void check_above_ground(const std::string& path);
  void check_threat(const ThreatSpec& threat, const std::string& path);

  const Scenario& scenario_;
  std::vector<Fault>& faults_;
  std::set<std::string> faulty_;
  bool frame_sound_ = true;
};

void Rules::check_terrain() {
  if (!scenario_.terrain) return;
  const TerrainSpec& terrain = *scenario_.terrain;
  const bool placed = scenario_.frame.origin || scenario_.frame.local;
  if (given("terrain.peaks") && !placed && frame_sound_) {
    report("terrain.peaks", {.limit = "frame: {local: true} or {origin: {lat, lon}}",
                             .message = "peaks need a local frame or one with an origin"});
  }
  if (terrain.ceiling_agl_m && sound("terrain.clearance_m") && *terrain.ceiling_agl_m <= terrain.clearance_m) {
    report("terrain.ceiling_agl_m", {.value = fmt::format("{}", *terrain.ceiling_agl_m),
                                     .limit = fmt::format("> {}", terrain.clearance_m),
                                     .unit = "m",
                                     .message = "must be above clearance_m"});
  }
}

void Rules::check_grid() {
  if (!scenario_.grid) return;
  for (const std::string path : {"terrain", "navigation"}) {
    if (given(path)) report(path, {.message = "cannot stand beside a grid"});
  }
  if (is_cut()) {
    check_cut_grid();
  } else {
    if (given("frame.origin")) report("frame.origin", {.message = "cannot stand beside a grid"});
    if (scenario_.frame.crs != "auto") report("frame.crs", {.message = "a grid lies in a local frame"});
    if (given("grid.clearance_m")) report("grid.clearance_m", {.message = "belongs to a grid cut from a dem"});
  }
  if (!scenario_.grid->random || !sound("grid.random.size")) return;
  const auto& [columns, rows] = scenario_.grid->random->size;
  if (const std::int64_t cells = std::int64_t{columns} * rows; cells > kMaxGridCells) {
    report("grid.random.size", {.value = fmt::format("{}", cells),
                                .limit = fmt::format("<= {}", kMaxGridCells),
                                .unit = "cells",
                                .message = "too large"});
  }
}

void Rules::check_cut_grid() {
  if (!given("grid.cell_m"))
    report("grid.cell_m", {.limit = fmt::format(">= {}", kLeastCell),
                           .unit = "m",
                           .message = "is missing: a dem is cut into cells of it"});
  if (given("grid.heights")) report("grid.heights", {.message = "a dem has its own heights"});
}

/// Start or goal beside a grid.
void Rules::check_cell(const std::string& path) {
  if (!given(path) || given(path + ".cell") || !sound(path)) return;
  const bool geographic = given(path + ".lat");
  if (!is_cut() || !geographic) {
    report(path, {.limit = is_cut() ? "{cell: [column, row]} or {lat, lon}" : "{cell: [column, row]}",
                  .message = "must be a cell of the grid"});
    return;
  }
  check_ground_frame(path, geographic);
  for (const char* height : {".amsl_m", ".agl_m"}) {
    if (given(path + height))
      report(path + height, {.message = "the route flies at grid.level_amsl_m; leave this height out"});
  }
}

/// lat and lon mean nothing in a local frame.
void Rules::check_ground_frame(const std::string& path, bool geographic) {
  if (!geographic || !scenario_.frame.local) return;
  report(path + ".lat", {.message = "a local frame has no place on Earth; write metres in the frame"});
}

void Rules::check_above_ground(const std::string& path) {
  if (!given(path + ".agl_m") || given("terrain") || is_cut()) return;
  report(path + ".agl_m", {.message = "needs terrain; without it write amsl_m"});
}

void Rules::check_places() {
  for (const std::string path : {"start", "goal"}) {
    if (scenario_.grid) {
      check_cell(path);
    } else {
      check_place(path);
    }
  }
}

void Rules::check_place(const std::string& path) {
  const bool automatic =
      !scenario_.frame.origin && !scenario_.frame.local && scenario_.frame.crs == "auto" && !scenario_.navigation;
  if (given(path + ".cell")) report(path + ".cell", {.message = "needs a grid"});
  check_ground_frame(path, given(path + ".lat") && given(path + ".lon"));
  check_above_ground(path);
  if (given(path + ".lat") && !given(path + ".amsl_m") && !given(path + ".agl_m") && sound(path)) {
    report(path, {.limit = "lat, lon, amsl_m | lat, lon, agl_m",
                  .message = "needs a height; only beside grid.dem lat and lon are enough"});
  }
  if (automatic && given(path + ".position_m") && frame_sound_) {
    report(path + ".position_m", {.limit = "frame: {local: true}, {origin: {lat, lon}} or {crs: \"EPSG:...\"}",
                                  .message = "crs: auto needs lat and lon; or name the frame of these metres"});
  }
}

void Rules::check_vehicle() {
  const VehicleSpec& vehicle = scenario_.vehicle;
  const std::size_t moves = vehicle.roll_deg.size() * vehicle.pitch_deg.size() * vehicle.yaw_deg.size();
  if (moves <= kMaxAttitudeMoves) return;
  report("vehicle", {.value = fmt::format("{}", moves),
                     .limit = fmt::format("<= {}", kMaxAttitudeMoves),
                     .message = "too many combinations of roll_deg, pitch_deg and yaw_deg"});
}

void Rules::check_threat(const ThreatSpec& threat, const std::string& path) {
  check_ground_frame(path, threat.lat_deg && threat.lon_deg);
  check_above_ground(path);
  if (threat.core_m > threat.radius_m && sound(path + ".radius_m")) {
    report(path + ".core_m", {.value = fmt::format("{}", threat.core_m),
                              .limit = fmt::format("<= {}", threat.radius_m),
                              .unit = "m",
                              .message = "must not exceed radius_m"});
  }
  if (!threat.cylinder) return;
  const CylinderSpec& cylinder = *threat.cylinder;
  const std::string inner = path + ".cylinder";
  check_ground_frame(inner, cylinder.lat_deg && cylinder.lon_deg);
  if (cylinder.top_m <= cylinder.floor_m && sound(inner + ".top_m") && sound(inner + ".floor_m")) {
    report(inner + ".top_m", {.value = fmt::format("{}", cylinder.top_m),
                              .limit = fmt::format("> {}", cylinder.floor_m),
                              .unit = "m",
                              .message = "must be above floor_m"});
  }
}

void Rules::check_threats() {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scenario_.threats.size(); ++i) {
    const ThreatSpec& threat = scenario_.threats[i];
    const std::string path = fmt::format("threats.{}", i);
    check_threat(threat, path);
    if (!names.insert(threat.name).second) {
      report(path + ".name", {.value = shortened(threat.name), .message = "another threat has this name"});
    }
  }
}

void Rules::check_objective() {
  const ObjectiveSpec& objective = scenario_.objective;
  if (!sound("objective.model")) return;
  const bool physical = objective.model == CostModel::physical;
  for (const char* key : {"length", "climb", "fuel"}) {
    const std::string path = std::string("objective.") + key;
    const bool belongs = physical == (std::string(key) != "fuel");
    if (!given(path) || belongs) continue;
    report(path, {.message = fmt::format("belongs to model {}", physical ? "konatowski2019" : "physical")});
  }
  const double sum = objective.fuel + objective.threat;
  if (physical || !sound("objective.fuel") || !sound("objective.threat") || std::abs(sum - 1) <= 1e-9) return;
  report("objective",
         {.value = fmt::format("{}", sum), .limit = "1", .message = "fuel + threat must be 1 (0.5 if not given)"});
}

void Rules::check_navigation() {
  if (!scenario_.navigation) return;
  const NavigationSpec& navigation = *scenario_.navigation;
  if (!given("navigation.points")) {
    report("navigation.points", {.limit = "a CSV file or a list of points",
                                 .message = "is missing: name it here, or by --override navigation.points=FILE"});
  }
  if (navigation.turn_model != TurnModel::none && !given("navigation.turn_radius_m")) {
    report("navigation.turn_radius_m", {.limit = "> 0", .unit = "m", .message = "is needed by turn_model"});
  }
  for (std::size_t i = 0; i < navigation.points.size(); ++i) {
    const CorrectionPointSpec& point = navigation.points[i];
    check_ground_frame(fmt::format("navigation.points.{}", i), point.lat_deg && point.lon_deg);
  }
}

}  // namespace

void check_rules(const Scenario& scenario, std::vector<Fault>& faults) {
  Rules rules(scenario, faults);
  rules.check_terrain();
  rules.check_grid();
  rules.check_places();
  rules.check_vehicle();
  rules.check_threats();
  rules.check_objective();
  rules.check_navigation();
}

}  // namespace alate
