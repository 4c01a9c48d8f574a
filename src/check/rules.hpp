// Every rule that a route is judged by, one function each. Names, order and meaning: docs of `check`.
#pragma once

#include "check/flight.hpp"
#include "check/rule.hpp"

namespace alate {

/// Lowest height above ground of each leg, at least the band's clearance. On a grid a blocked cell is ground of endless
/// height, see judge_blocked_cells; of a grid cut from a raster the ground itself is judged as well.
RuleReport judge_terrain_clearance(const Flight& flight);

/// Counts, leg by leg, where the route touches blocked cells: flies through the inside of one or along a side that all
/// cells beside it block, or changes cells across a corner of one, in space also an edge (no corner cutting). A route
/// may run along one side of a blocked cell. Part of terrain_clearance; what lies outside the map is left to `bounds`.
/// Over ground, which gives a leg a margin in metres, legs that touch none are passed over.
void judge_blocked_cells(const Flight& flight, RuleReport& report);

/// Highest height of each leg, at most the ceilings above ground and above sea level; the worse of both.
RuleReport judge_ceiling(const Flight& flight);

/// Distance to the centre of a sphere, or to the axis of a cylinder between its floor and top, at least the core.
/// For a leg wholly above or below a cylinder the value is the core plus the gap in height, if that is more.
RuleReport judge_threat_core(const Flight& flight);

/// Radius for which each turn has room: a circle of radius r rounds a corner of theta between straight legs from
/// r tan(theta/2) before it to as much behind it, and two corners may not overlap on the leg between them. So a leg of
/// length L has room for r = L / (tan(theta1/2) + tan(theta2/2)), and a corner has that of the tighter of its legs.
/// Legs without planar length are passed over. The start's heading, if given, takes room of the first leg alone. An arc
/// has its own radius and gives no room: a change of heading where it joins, or a gap there, counts as radius 0.
/// Without any turn the radius is 1e9 m. Headings and lengths are those in the plane; in space where the turn radius is
/// the navigation's (Zhou et al. 2020, problem 2), and on routes with an arc in a tilted plane.
RuleReport judge_turn(const Flight& flight);

/// Angle of each leg to the horizontal.
RuleReport judge_climb(const Flight& flight);
RuleReport judge_descent(const Flight& flight);

/// Replays the actions from the start's heading, F' = F Rx(roll) Ry(-pitch) Rz(-yaw), p' = p + step F' e_x with F =
/// (forward, left, up) (Konatowski and Pawlowski 2019, eqs. 15-24, with the signs of alate's angles), and compares
/// each leg with what its action gives. Every action must be one of the scenario's.
RuleReport judge_step(const Flight& flight);

/// Each leg inside the outermost posts, the extent of the peaks, the grid or the voxels; metres to the nearest edge.
/// The area is convex, so the ends of the pieces suffice.
RuleReport judge_bounds(const Flight& flight);

/// The last state within the goal's tolerance, the first within 1 m of the start (reported only if it is not). Each
/// state that bears the id of a correction point at that point (reported only if it is not); 1e9 m from a point that
/// does not exist.
RuleReport judge_arrival(const Flight& flight);

/// Errors on arrival at each correction point that the route names, every correction working, at most what a point of
/// that kind allows (Zhou et al. 2020, problem 1). A route that names none is corrected nowhere.
RuleReport judge_vertical_error(const Flight& flight);
RuleReport judge_horizontal_error(const Flight& flight);

/// Both errors at the last state, below theta without slack.
RuleReport judge_final_error(const Flight& flight);

/// Length of the route, at most the range.
RuleReport judge_endurance(const Flight& flight);

}  // namespace alate
