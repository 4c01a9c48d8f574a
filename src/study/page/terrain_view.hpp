// Routes over hills as a picture of space.
#pragma once

#include <string>
#include <vector>

#include "alate/world/world.hpp"
#include "study/page/scene_view.hpp"

namespace alate {

struct TerrainPicture {
  const World& world;
  Box2 area;                ///< Frame metres.
  int cells = 40;           ///< Along each side.
  double exaggeration = 5;  ///< Heights are drawn so many times as large.
};

/// Axonometric drawing of the shaded ground with routes above it. Where a hill hides a route it shines through faintly.
/// Labels on the axes are km.
std::string terrain_svg(const TerrainPicture& picture, const std::vector<SceneRoute>& routes, const std::string& title);

/// Colours of the ground.
extern const std::string_view kTerrainStyle;

}  // namespace alate
