// Sites over random hills, for laws that must hold on any ground.
#pragma once

#include <cmath>
#include <vector>

#include "alate/core/stream.hpp"
#include "support/hand_made_sites.hpp"

namespace alate::test {

/// 6 km x 5 km of ridges up to 500 m high, posts 50 m apart, the band 50 to 400 m above them; start and goal lie in
/// opposite quarters, 150 m above ground. A sphere stands somewhere between them.
inline Site rough_site(std::uint64_t seed) {
  Stream random(seed, 0, 0);
  struct Wave {
    double x, y, phase, height;
  };
  std::vector<Wave> waves;
  for (int k = 1; k <= 6; ++k)
    waves.push_back({.x = 0.0012 * k * (random.uniform() - 0.5),
                     .y = 0.0012 * k * (random.uniform() - 0.5),
                     .phase = 2 * kPi * random.uniform(),
                     .height = 250.0 / k});
  Site site;
  const HeightRaster raster = raster_of(121, 101, 50, [&](double x, double y) {
    double sum = 300;
    for (const Wave& wave : waves) sum += wave.height * std::sin(2 * kPi * (wave.x * x + wave.y * y) + wave.phase);
    return sum;
  });
  site.ground = raster;
  site.band = {.clearance_m = 50, .ceiling_agl_m = 400, .ceiling_amsl_m = {}};
  const auto place = [&](double x, double y) {
    const Vec2 at(x + 1000 * random.uniform(), y + 1000 * random.uniform());
    return Vec3(at.x(), at.y(), *raster.height(at) + 150);
  };
  site.mission.start = place(500, 500);
  site.mission.goal = place(4500, 3500);
  site.mission.tolerance_m = 50;
  site.vehicle = {.turn_radius_m = 60, .climb_rad = radians(8), .descent_rad = radians(6)};
  site.scenario.objective = {.length = 1, .threat = 5, .climb = 1};
  site.threats.push_back({.name = "radar", .center = place(2500, 2000), .radius_m = 600, .level = 1, .core_m = 100});
  return site;
}

}  // namespace alate::test
