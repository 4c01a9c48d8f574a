// The shortest way of bounded curvature where one end has no heading.
#pragma once

#include "space/dubins/dubins_path.hpp"

namespace alate {

/// The shortest path to a point, whatever the heading there: a turn and a straight piece or, to a point within a circle
/// of the start, a turn away from it and one back (Boissonnat, Bui 1994). The word it is told as lacks a piece: its
/// last turn, or the straight one. Never longer than `shortest_dubins` to any heading there.
DubinsPath shortest_dubins_to_point(const PlanarPose& from, const Vec2& to, double radius_m);

/// Likewise from a point, whatever the heading there.
DubinsPath shortest_dubins_from_point(const Vec2& from, const PlanarPose& to, double radius_m);

}  // namespace alate
