// Routes over spheres as a picture of space.
#pragma once

#include <string>
#include <vector>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

struct SceneRoute {
  const Route* route = nullptr;
  std::string css_class;  ///< "w0", "w1", ...: colour and dash of the line.
};

/// Axonometric drawing of start, goal, spheres (nearer ones over farther ones, with wire rings) and routes with drop
/// lines to a floor grid. Labels on the axes are frame units.
std::string scene_svg(const Site& site, const std::vector<SceneRoute>& routes, const std::string& title);

}  // namespace alate
