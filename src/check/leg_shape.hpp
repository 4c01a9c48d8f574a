// The geometry of one leg, straight or arc.
#pragma once

#include <vector>

#include "alate/core/route.hpp"

namespace alate {

/// Position on leg `i` at t in [0, 1]; height is linear along an arc.
Vec3 point_on_leg(const Route& route, std::size_t i, double t);

/// Planar length, metres: r * |angle| of an arc.
double planar_length_of_leg(const Route& route, std::size_t i);

/// Length in space, metres.
double length_of_leg(const Route& route, std::size_t i);

/// Angle to the horizontal, positive upwards.
double climb_angle_of_leg(const Route& route, std::size_t i);

/// Direction of flight where the leg begins and where it ends; only x and y count.
Vec3 first_direction(const Route& route, std::size_t i);
Vec3 last_direction(const Route& route, std::size_t i);

/// How far, metres, the arc of leg `i` misses the states it should join. Zero for a straight leg.
double arc_gap(const Route& route, std::size_t i);

/// A straight leg as it is; an arc as chords that stay within 0.01 m of it.
std::vector<Segment> straight_pieces(const Route& route, std::size_t i);

}  // namespace alate
