#include "out/report/map_frame.hpp"

#include <algorithm>

namespace alate {

namespace {

constexpr double kFlattest = 0.5;  ///< Height by width.
constexpr double kTallest = 1.0;
constexpr double kMargin = 0.1;
constexpr double kLeastSize = 50;  ///< Metres.

void include(Box2& box, const Vec2& center, double radius) {
  box.min = box.min.cwiseMin(center - Vec2::Constant(radius));
  box.max = box.max.cwiseMax(center + Vec2::Constant(radius));
}

Box2 widened(const Box2& box, double by) { return {box.min - Vec2::Constant(by), box.max + Vec2::Constant(by)}; }

double longest_side(const Box2& box) { return std::max((box.max - box.min).maxCoeff(), kLeastSize); }

bool overlaps(const Box2& box, const Threat& threat) {
  return widened(box, threat.radius_m).contains(threat.center.head<2>());
}

/// Grows the shorter side, half at each end, until the proportions are pleasant.
Box2 proportioned(const Box2& box, double least = kLeastSize) {
  const Vec2 size = (box.max - box.min).cwiseMax(least);
  const Vec2 center = (box.min + box.max) / 2;
  const Vec2 wanted{std::max(size.x(), size.y() / kTallest), std::max(size.y(), size.x() * kFlattest)};
  return {center - wanted / 2, center + wanted / 2};
}

/// The whole map of cells, and a route that leaves it.
Box2 area_of(Box2 box, const Route& route) {
  constexpr double kBorder = 0.02;
  for (const RouteState& state : route.states) include(box, state.position.head<2>(), 0);
  return proportioned(widened(box, kBorder * (box.max - box.min).maxCoeff()), 0);
}

}  // namespace

MapFrame map_frame(const Site& site, const Route& route, double width) {
  if (site.grid) return {.area = area_of(site.grid->area(), route), .width = width};
  if (site.voxels) return {.area = area_of(site.voxels->area(), route), .width = width};
  const Mission& mission = site.mission;
  Box2 box{mission.start.head<2>(), mission.start.head<2>()};
  include(box, mission.goal.head<2>(), mission.tolerance_m);
  for (const RouteState& state : route.states) include(box, state.position.head<2>(), 0);
  const Box2 flown = box;
  for (const Threat& threat : site.threats) {
    if (overlaps(flown, threat))
      include(box, threat.center.head<2>(), std::min(threat.radius_m, longest_side(flown) / 4));
  }
  return {.area = proportioned(widened(box, kMargin * longest_side(box))), .width = width};
}

}  // namespace alate
