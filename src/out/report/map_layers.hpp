// What maps are drawn of, layer by layer.
#pragma once

#include "alate/check/check.hpp"
#include "out/report/hillshade.hpp"
#include "out/report/map_frame.hpp"
#include "out/report/svg.hpp"

namespace alate {

/// The ground from above in about `columns` columns, cells, or a grid in frame metres where there is neither. Returns
/// what was drawn, for the key.
Hillshade draw_ground(Svg& svg, const MapFrame& map, const Site& site, int columns);

void draw_threats(Svg& svg, const MapFrame& map, const Site& site);
void draw_threat_names(Svg& svg, const MapFrame& map, const Site& site);

/// The route with its waypoints, where these are not too crowded.
void draw_route(Svg& svg, const MapFrame& map, const Route& route);

/// A cross at every place where a rule is broken.
void draw_violations(Svg& svg, const MapFrame& map, const Verdict& verdict);

/// Start and goal with their names.
void draw_ends(Svg& svg, const MapFrame& map, const Mission& mission);

}  // namespace alate
