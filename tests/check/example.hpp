// A valid route with every rule given, over ground that rises from 100 m in the west to 200 m in the east.
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <string>

#include "alate/check/check.hpp"

namespace alate::test {

inline constexpr double kCell = 100;

/// Posts every 100 m from (0, 0), north up.
inline HeightRaster make_raster(int columns, int rows, const std::function<double(double x, double y)>& height) {
  HeightRaster raster;
  raster.columns = columns;
  raster.rows = rows;
  const double top = (rows - 1) * kCell;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      raster.posts.push_back(static_cast<float>(height(column * kCell, top - row * kCell)));
    }
  }
  raster.map = PostMap::affine({0, 1 / kCell, 0, top / kCell, 0, -1 / kCell});
  raster.area = {Vec2(0, 0), Vec2((columns - 1) * kCell, top)};
  raster.cell_m = kCell;
  return raster;
}

inline Route make_route(const std::vector<Vec3>& positions) {
  Route route;
  for (const Vec3& position : positions) {
    route.states.push_back({.position = position, .leg = route.empty() ? LegKind::start : LegKind::straight});
  }
  return route;
}

inline Site example_site() {
  Site site;
  site.ground = make_raster(41, 41, [](double x, double) { return 100 + x / 40; });
  site.band = {.clearance_m = 50, .ceiling_agl_m = 300, .ceiling_amsl_m = 450};
  site.mission = {.start = {500, 150, 300},
                  .heading_rad = kPi / 2,
                  .heading_given = true,
                  .goal = {3500, 350, 300},
                  .tolerance_m = 50};
  site.vehicle.turn_radius_m = 250;
  site.vehicle.climb_rad = radians(25);
  site.vehicle.descent_rad = radians(25);
  site.vehicle.range_m = 4000;
  site.threats = {{.name = "radar", .center = {2000, 700, 300}, .radius_m = 600, .level = 1, .core_m = 200},
                  {.name = "tower",
                   .shape = Threat::Shape::cylinder,
                   .center = {1000, 700, 0},
                   .radius_m = 500,
                   .level = 1,
                   .core_m = 100,
                   .floor_m = 0,
                   .top_m = 400}};
  return site;
}

inline Route example_route() {
  return make_route({{500, 150, 300},
                     {1000, 150, 300},
                     {1500, 150, 320},
                     {2000, 250, 320},
                     {2500, 350, 300},
                     {3000, 350, 300},
                     {3500, 350, 300}});
}

/// A scenario with attitude steps and nothing else but its start and goal.
inline Site attitude_site() {
  Site site;
  site.mission = {.start = {0, 0, 1000}, .heading_rad = radians(30), .heading_given = true, .goal = {0, 0, 1000}};
  site.mission.tolerance_m = 1e5;
  site.vehicle.step_m = 300;
  site.vehicle.roll_rad = {-radians(15), 0, radians(15)};
  site.vehicle.pitch_rad = {-radians(4), 0, radians(4)};
  site.vehicle.yaw_rad = {-radians(7.5), 0, radians(7.5)};
  return site;
}

inline std::set<std::string> broken_rules(const Verdict& verdict) {
  std::set<std::string> rules;
  for (const Violation& violation : verdict.violations) rules.insert(violation.rule);
  return rules;
}

inline std::set<std::size_t> broken_legs(const Verdict& verdict) {
  std::set<std::size_t> legs;
  for (const Violation& violation : verdict.violations) legs.insert(violation.leg);
  return legs;
}

inline const Margin* find_margin(const Verdict& verdict, const std::string& rule) {
  const auto found = std::ranges::find(verdict.margins, rule, &Margin::rule);
  return found == verdict.margins.end() ? nullptr : &*found;
}

inline const NotChecked* find_not_checked(const Verdict& verdict, const std::string& rule) {
  const auto found = std::ranges::find(verdict.not_checked, rule, &NotChecked::rule);
  return found == verdict.not_checked.end() ? nullptr : &*found;
}

}  // namespace alate::test
