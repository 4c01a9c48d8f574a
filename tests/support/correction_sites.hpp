// Sites with correction points: the contest's two sets, and synthetic ones by their law.
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "data/correction_law.hpp"
#include "support/shared_data.hpp"

namespace alate::test {

/// Straight legs, shortest route.
inline Site correction_site(CorrectionField field) {
  Site site;
  site.scenario.objective.climb = 0;
  site.mission.start = field.start;
  site.mission.goal = field.goal;
  site.navigation = std::move(field.navigation);
  return site;
}

inline Site drawn_site(CorrectionLaw law, int points, std::uint64_t seed) {
  return correction_site(draw_corrections(law, points, seed));
}

/// With a cylinder across the direct way that must not be entered.
inline Site cored_site() {
  Site site = drawn_site(CorrectionLaw::set1, 1200, 5);
  const Vec3 middle = (site.mission.start + site.mission.goal) / 2;
  site.threats.push_back({.name = "core",
                          .shape = Threat::Shape::cylinder,
                          .center = {middle.x(), middle.y(), 0},
                          .radius_m = 0,
                          .core_m = 12'000,
                          .top_m = 20'000});
  return site;
}

/// As published: limits by `law`, points from the shared data.
inline CorrectionField contest_field(CorrectionLaw law) {
  CorrectionField field = draw_corrections(law, 0, 1);
  std::ifstream file(
      shared_data(law == CorrectionLaw::set1 ? "correction-points/set1.csv" : "correction-points/set2.csv"));
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string id, x, y, z, kind, may_fail;
    for (std::string* cell : {&id, &x, &y, &z, &kind, &may_fail}) std::getline(cells, *cell, ',');
    const Vec3 position(std::stod(x), std::stod(y), std::stod(z));
    if (kind == "start") {
      field.start = position;
    } else if (kind == "end") {
      field.goal = position;
      field.navigation.goal_id = std::stoi(id);
    } else {
      field.navigation.points.push_back({.id = std::stoi(id),
                                         .position = position,
                                         .kind = kind == "vertical" ? PointKind::vertical : PointKind::horizontal,
                                         .success = may_fail.starts_with('1') ? 0.8 : 1.0});
    }
  }
  return field;
}

/// The same with corrections that always work: problem 1.
inline CorrectionField never_failing(CorrectionField field) {
  for (CorrectionPoint& point : field.navigation.points) point.success = 1;
  return field;
}

}  // namespace alate::test

#define ALATE_NEEDS_CONTEST_POINTS ALATE_NEEDS_SHARED_DATA("correction-points/set1.csv")
