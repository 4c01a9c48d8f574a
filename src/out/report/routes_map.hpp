// Several routes over one map.
#pragma once

#include <string>
#include <vector>

#include "alate/check/check.hpp"
#include "out/report/map_frame.hpp"

namespace alate {

struct MapRoute {
  const Route* route = nullptr;
  bool faint = false;                ///< One of many, drawn below the others.
  const Verdict* verdict = nullptr;  ///< Places where it breaks rules are crossed; null: none.
};

/// A drawing without a key: ground, threats, routes, start and goal.
std::string routes_map(const Site& site, const MapFrame& map, const std::vector<MapRoute>& routes,
                       const std::string& title);

}  // namespace alate
