// The correction points of the map.
#pragma once

#include <string>

#include "out/report/map_frame.hpp"
#include "out/report/svg.hpp"

namespace alate {

/// Vertical points are triangles, horizontal ones diamonds, hollow if they may fail. Of more than a few thousand in
/// view only every n-th is drawn, and those of the route. Nothing without navigation.
void draw_points(Svg& svg, const MapFrame& map, const Site& site);

/// The points that the route names, larger, with their ids; drawn over the route.
void draw_used_points(Svg& svg, const MapFrame& map, const Site& site, const Route& route);

/// Items of the map's legend.
std::string points_key(const MapFrame& map, const Site& site);

}  // namespace alate
