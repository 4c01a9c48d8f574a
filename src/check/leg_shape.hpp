// The geometry of one leg, straight or arc.
#pragma once

#include <vector>

#include "alate/core/route.hpp"
#include "check/level_band.hpp"
#include "check/tilted_arc.hpp"

namespace alate {

/// Position on leg `i` at t in [0, 1]; height is linear along an arc, unless its plane is tilted.
Vec3 point_on_leg(const Route& route, std::size_t i, double t);

/// Planar length, metres: r * |angle| of an arc. Not of a tilted one: that is measured in space alone.
double planar_length_of_leg(const Route& route, std::size_t i);

/// Length in space, metres.
double length_of_leg(const Route& route, std::size_t i);

/// Largest angle to the horizontal, upwards for `sign` 1 and downwards for -1; negative if it only goes the other way.
double steepest_angle_of_leg(const Route& route, std::size_t i, double sign);

/// Climb and descent along leg `i`.
Rise rise_of_leg(const Route& route, std::size_t i);

/// Parts of leg `i`, as shares of it, that lie within [floor, top].
std::vector<Part> parts_of_leg_between(const Route& route, std::size_t i, double floor, double top);

/// Direction of flight where the leg begins and where it ends, of any length.
Vec3 first_direction(const Route& route, std::size_t i);
Vec3 last_direction(const Route& route, std::size_t i);

/// How far, metres, the arc of leg `i` misses the states it should join. Zero for a straight leg.
double arc_gap(const Route& route, std::size_t i);

/// A straight leg as it is; an arc as chords that stay within 0.01 m of it.
std::vector<Segment> straight_pieces(const Route& route, std::size_t i);

}  // namespace alate
