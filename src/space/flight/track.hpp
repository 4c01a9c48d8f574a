// A way over the ground: arcs of the aircraft's circle and straight pieces, each beginning where the last one ends.
#pragma once

#include <vector>

#include "space/dubins/dubins_pieces.hpp"

namespace alate {

using Track = std::vector<PlanarPiece>;

/// Shorter pieces have no direction or slope, to the rounding of places.
inline constexpr double kLeastPiece_m = 0.1;

double length_of(const Track& track);

/// The same places, flown the other way.
PlanarPiece reversed(const PlanarPiece& piece);

/// Adds the pieces of a Dubins path but for those that rounding alone brings.
void append(Track& track, const DubinsPath& path);

}  // namespace alate
