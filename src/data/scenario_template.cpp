#include "alate/data/scenario_file.hpp"
#include "data/scenario_writer.hpp"

namespace alate {

namespace {

/// Two hills and a radar on a field of 20 by 20 km: needs no file, and the direct line is no answer.
Scenario sample() {
  Scenario scenario;
  scenario.frame.local = true;
  scenario.terrain = TerrainSpec{.peaks = {{.center_m = {9000, 11000}, .height_m = 600, .slope_m = {2500, 2000}},
                                           {.center_m = {14000, 9000}, .height_m = 400, .slope_m = {1500, 2500}}},
                                 .extent_m = {{20000, 20000}},
                                 .clearance_m = 60,
                                 .ceiling_agl_m = 300};
  scenario.start = {.place = {.position_m = {{2000, 2000, 150}}}, .heading_deg = 45};
  scenario.goal = {.place = {.position_m = {{18000, 18000, 150}}}, .tolerance_m = 300};
  scenario.vehicle = {.speed_mps = 20,
                      .turn_radius_m = 80,
                      .climb_deg = 8,
                      .descent_deg = 10,
                      .range_m = 60000,
                      .step_m = 300,
                      .roll_deg = {-15, -7.5, 0, 7.5, 15},
                      .pitch_deg = {-6, -3, 0, 3, 6},
                      .yaw_deg = {-15, -7.5, 0, 7.5, 15}};
  scenario.threats = {{.name = "radar", .center_m = {{12000, 13500, 200}}, .radius_m = 3000, .core_m = 500}};
  return scenario;
}

}  // namespace

std::string scenario_template() {
  return "# A scenario for alate. Every key stands below; one that begins with # is not given.\n"
         "# Lengths are metres, heights are above mean sea level, angles are degrees.\n" +
         write_scenario(sample(), Comments::all);
}

}  // namespace alate
