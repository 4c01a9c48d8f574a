// Sites over hills, for tests of the terrain lattice.
#pragma once

#include "alate/data/site.hpp"

namespace alate::test {

/// The simple terrain of Mai et al. 2023, table 1; ends and band are ours.
inline Site simple_site() {
  Site site;
  site.ground = PeakGround{.peaks = {{.center = {30000, 9000}, .height_m = 660, .slope_m = {4000, 3000}},
                                     {.center = {16000, 17000}, .height_m = 1640, .slope_m = {7000, 8000}},
                                     {.center = {35000, 32000}, .height_m = 1300, .slope_m = {5000, 8000}}},
                           .maximum = false,
                           .area = {.min = {0, 0}, .max = {50000, 50000}}};
  site.band = {.clearance_m = 100, .ceiling_agl_m = {}, .ceiling_amsl_m = 3000};
  site.mission = {.start = {0, 0, 1000}, .goal = {50000, 50000, 1000}};
  return site;
}

/// A plain at sea level of 20 km x 20 km, flown 10 km along x at 500 m.
inline Site flat_site() {
  Site site;
  site.ground = PeakGround{.peaks = {}, .maximum = false, .area = {.min = {0, 0}, .max = {20000, 20000}}};
  site.band = {.clearance_m = 100, .ceiling_agl_m = {}, .ceiling_amsl_m = 3000};
  site.mission = {.start = {5000, 10000, 500}, .goal = {15000, 10000, 500}};
  return site;
}

}  // namespace alate::test
