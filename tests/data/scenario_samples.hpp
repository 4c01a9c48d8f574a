// Scenario texts for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/data/scenario_file.hpp"

namespace alate::test {

/// Every kind of field at least once.
inline const std::string kFullScenario = R"(frame: {origin: {lat: 36.3, lon: -84.25}}
terrain:
  peaks: [{center_m: [100, 200], height_m: 300, slope_m: [50, 60]}]
  combine: max
  extent_m: [1000, 2000]
  clearance_m: 60
  ceiling_agl_m: 400
  ceiling_amsl_m: 1500
start: {lat: 36.378, lon: -84.1263, agl_m: 120, heading_deg: 225}
goal: {position_m: [10, 20, 30.5], tolerance_m: 300}
vehicle:
  speed_mps: 20
  turn_radius_m: 80
  climb_deg: 8
  descent_deg: 10
  range_m: 60000
  step_m: 300
  roll_deg: [-15, -7.5, 0, 7.5, 15]
  pitch_deg: [0]
  yaw_deg: [-1, 1]
threats:
- {name: radar, center_m: [11, 8, 6.5], radius_m: 4, level: 0.5, core_m: 1}
- {lat: 36.3, lon: -84.2, amsl_m: 500, radius_m: 900}
- {name: tower, cylinder: {center_m: [1, 2], floor_m: 0, top_m: 90}, radius_m: 5}
objective: {model: konatowski2019, fuel: 0.2, threat: 0.8}
planner: {name: attitude-aco, preset: guided, parameters: {ants: 20, score: J+h}}
)";

/// Every key of `navigation`, in a frame of its own.
inline const std::string kNavigationScenario = R"(navigation:
  points:
  - {id: 7, position_m: [0, 0, 100], kind: start}
  - {id: 8, position_m: [5000, 100, 200], kind: vertical, may_fail: true}
  - {position_m: [9000, 0, 100], kind: horizontal}
  - {id: 9, position_m: [14000, 0, 100], kind: end}
  drift_per_m: {vertical: 0.001, horizontal: 0.002}
  alpha: [25, 15]
  beta: [20, 25]
  theta: 30
  success: 0.75
  residual: 4
  turn_radius_m: 200
  turn_model: arc_tangent
)";

/// Every key of `grid` but the map.
inline const std::string kGridScenario =
    "grid: {random: {size: [30, 20], obstacles: 0.3, seed: 4}, heights: peaks, cell_m: 10}\n"
    "start: {cell: [0, 19]}\n"
    "goal: {cell: [29, 0]}\n";

/// The least that is a scenario, in five lines, for a fault in an added line 6.
inline const std::string kSmallScenario = R"(# small
frame:
  local: true
start: {position_m: [0, 0, 100]}
goal: {position_m: [1000, 0, 100]}
)";

inline std::vector<Fault> faults_in(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_scenario(text, "s.yaml", overrides);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

/// `text` with its only `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace alate::test
