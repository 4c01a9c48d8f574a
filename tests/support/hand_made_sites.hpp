// Sites built without files, for tests of spaces and planners.
#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <ostream>
#include <vector>

#include "alate/data/site.hpp"

namespace alate::test {

inline std::vector<double> angles(std::initializer_list<double> in_degrees) {
  std::vector<double> result;
  for (const double angle : in_degrees) result.push_back(radians(angle));
  return result;
}

struct Sphere {
  double x, y, z, radius;
};

/// Layouts of our own for Konatowski, Pawlowski 2019, whose figure cannot be recovered.
inline const std::vector<Sphere> kLayoutA{{13.5, 10.5, 7.5, 5}};
inline const std::vector<Sphere> kLayoutC{{11, 8, 6.5, 4}, {15, 12, 8, 4}, {17.5, 17, 9, 3}};
inline const std::vector<Sphere> kLayoutF{{16.9, 13.6, 5.2, 8}, {16.1, 12.6, 4.9, 8}, {16.5, 14, 5.2, 8}};

/// The published problem: step 2, tolerance 2, start (7, 1, 5) facing +x, goal (20, 20, 10), levels 0.5.
inline Site konatowski_site(double fuel, const std::vector<Sphere>& spheres) {
  Site site;
  site.scenario.objective = {
      .model = CostModel::konatowski2019, .length = 0, .threat = 1 - fuel, .climb = 0, .fuel = fuel};
  site.mission = {
      .start = {7, 1, 5}, .heading_rad = radians(90), .heading_given = true, .goal = {20, 20, 10}, .tolerance_m = 2};
  site.vehicle.step_m = 2;
  site.vehicle.roll_rad = site.vehicle.pitch_rad = site.vehicle.yaw_rad = angles({-15, -7.5, 0, 7.5, 15});
  for (const Sphere& s : spheres)
    site.threats.push_back({.name = "threat", .center = {s.x, s.y, s.z}, .radius_m = s.radius, .level = 0.5});
  return site;
}

/// Ground of `columns` x `rows` posts `cell_m` apart from (0, 0), row 0 in the south.
inline HeightRaster raster_of(int columns, int rows, double cell_m,
                              const std::function<double(double x, double y)>& height) {
  HeightRaster raster;
  raster.columns = columns;
  raster.rows = rows;
  raster.map = PostMap::affine({0, 1 / cell_m, 0, 0, 0, 1 / cell_m});
  raster.area = {.min = {0, 0}, .max = {(columns - 1) * cell_m, (rows - 1) * cell_m}};
  raster.cell_m = cell_m;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      raster.posts.push_back(static_cast<float>(height(column * cell_m, row * cell_m)));
  return raster;
}

/// A plain of 10 km x 8 km with a wall across it from south to north, 1000 m high, at x = 5000 m, and a ceiling below
/// its top. With `gap` it is
/// open between y = 6000 m and 7000 m. Start and goal lie 4 km before and behind it, both at y = 2000 m.
inline Site ridge_site(bool gap = true) {
  Site site;
  site.ground = raster_of(101, 81, 100, [gap](double x, double y) {
    const bool open = gap && y > 5950 && y < 7050;
    return std::abs(x - 5000) < 350 && !open ? 1000.0 : 0.0;
  });
  site.band = {.clearance_m = 50, .ceiling_agl_m = 400, .ceiling_amsl_m = 600};
  site.mission = {.start = {1000, 2000, 150},
                  .heading_rad = radians(90),
                  .heading_given = true,
                  .goal = {9000, 2000, 150},
                  .tolerance_m = 200};
  site.vehicle = {.turn_radius_m = 100, .climb_rad = radians(8), .descent_rad = radians(10), .step_m = 200};
  site.vehicle.roll_rad = site.vehicle.yaw_rad = angles({-15, -7.5, 0, 7.5, 15});
  site.vehicle.pitch_rad = angles({-6, -3, 0, 3, 6});
  return site;
}

/// Open air, physical cost, one sphere on the direct line.
inline Site open_air_site() {
  Site site;
  site.mission = {.start = {0, 0, 300},
                  .heading_rad = radians(60),
                  .heading_given = true,
                  .goal = {5000, 0, 400},
                  .tolerance_m = 150};
  site.vehicle = {.turn_radius_m = 80, .climb_rad = radians(8), .descent_rad = radians(8), .step_m = 150};
  site.vehicle.roll_rad = angles({-15, 0, 15});
  site.vehicle.pitch_rad = angles({-4, 0, 4});
  site.vehicle.yaw_rad = angles({-15, -7.5, 0, 7.5, 15});
  site.threats.push_back({.name = "radar", .center = {2500, 0, 300}, .radius_m = 900, .level = 1, .core_m = 300});
  return site;
}

/// One cell of the paper's tables on one of our layouts.
struct LayoutCase {
  const char* name;
  const std::vector<Sphere>& layout;
  double fuel;
  double best_known;
};

inline void PrintTo(const LayoutCase& one, std::ostream* out) { *out << one.name; }

}  // namespace alate::test
