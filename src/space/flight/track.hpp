// A way over the ground: arcs of the aircraft's circle and straight pieces, each beginning where the last one ends.
#pragma once

#include <vector>

#include "space/dubins/dubins_pieces.hpp"

namespace alate {

using Track = std::vector<PlanarPiece>;

double length_of(const Track& track);

/// The same places, flown the other way.
PlanarPiece reversed(const PlanarPiece& piece);

/// Adds the pieces of a Dubins path that have any length.
void append(Track& track, const DubinsPath& path);

}  // namespace alate
