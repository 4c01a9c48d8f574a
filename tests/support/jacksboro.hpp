// The example's ground, as a scenario and as a site.
#pragma once

#include <string>

#include "alate/core/scenario.hpp"
#include "alate/data/site.hpp"

namespace alate::test {

inline std::string jacksboro_file() { return ALATE_SOURCE_DIR "/examples/jacksboro/jacksboro.tif"; }

/// From Jacksboro's valley to New River valley, 120 m above ground, 50 m clearance, no ceiling, no threats.
inline Scenario jacksboro_scenario() {
  Scenario scenario;
  scenario.file = "jacksboro.yaml";
  scenario.terrain = TerrainSpec{.dem = jacksboro_file(), .clearance_m = 50};
  scenario.start.place = {.lat_deg = 36.378, .lon_deg = -84.1263, .agl_m = 120};
  scenario.goal = {.place = {.lat_deg = 36.2733, .lon_deg = -84.3825, .agl_m = 120}, .tolerance_m = 300};
  return scenario;
}

inline Site jacksboro() { return load_site(jacksboro_scenario()); }

}  // namespace alate::test
