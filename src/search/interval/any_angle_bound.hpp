// A better lower bound for flights over real ground: the shortest way at any angle through what is left of the plane.
//
// Suppose that a route costs less than some level. It never crosses a side of a cell whose price (`Passage`) reaches
// the level, so cells all of whose sides are that dear can be closed. Through the cells that are left the shortest way
// at any angle is found exactly (Anya); it tells how long the route is at the least, seen from above, and so what it
// costs. If that reaches the level, no route costs less than the level; if not, none costs less than that. The level is
// found by bisection.
#pragma once

#include "alate/core/run_context.hpp"
#include "alate/world/problem.hpp"

namespace alate {

struct AnyAngleBoundOptions {
  double least = 0;  ///< A bound that is known.
  double most = 0;   ///< Cost of a route that is known.
  double most_cells = 400'000;
};

/// For the physical objective over ground, at least `least`. A tenth of a second or more; stops early when `run` says
/// so.
double any_angle_bound(const Problem& problem, const AnyAngleBoundOptions& options, RunContext& run);

}  // namespace alate
