// Sites where a fixed wing flies over correction points and ground.
#pragma once

#include "support/hand_made_sites.hpp"

namespace alate::test {

/// The wall with a gap; points on the way to the gap, in it and behind it: 1, 2, 3. With `decoys` three more that lead
/// into the wall.
inline Site drifting_site(bool decoys) {
  Site site = ridge_site();
  Navigation navigation{
      .drift_vertical = 0.001, .drift_horizontal = 0.001, .at_vertical = {8, 5}, .at_horizontal = {5, 8}, .theta = 8};
  const auto add = [&](double x, double y, PointKind kind) {
    const int id = static_cast<int>(navigation.points.size()) + 1;
    navigation.points.push_back({.id = id, .position = {x, y, 150}, .kind = kind});
  };
  add(2900, 4300, PointKind::vertical);
  add(5000, 6500, PointKind::horizontal);
  add(7200, 4200, PointKind::vertical);
  if (decoys) {
    add(5200, 2000, PointKind::vertical);  // in the wall
    add(3500, 2000, PointKind::horizontal);
    add(7000, 1500, PointKind::horizontal);
  }
  site.navigation = navigation;
  site.scenario.objective = {.model = CostModel::physical, .length = 1, .threat = 0, .climb = 1};
  return site;
}

}  // namespace alate::test
