// What the paper judges a path by, written anew from its equations for routes of any planner.
#pragma once

#include <vector>

#include "alate/core/route.hpp"

namespace alate::mai2023 {

/// Parts of F, eqs. (21) to (23): km, km and radians.
struct Fitness {
  double length = 0;   ///< C_0.
  double heights = 0;  ///< C_h: of the legs' ends.
  double turns = 0;    ///< C_theta.

  /// Eq. (20), all weights 1.
  double sum() const { return length + heights + turns; }
};

/// Of a path of straight legs.
Fitness fitness_of(const std::vector<Vec3>& places);

/// Places of a route in planes `step_m` apart along x. C_h and C_theta grow with the number of legs, so only routes
/// with as many legs can be compared: a route that left the lattice is cut by its planes. Empty for a route that turns
/// back in x.
std::vector<Vec3> cut_by_planes(const Route& route, double step_m);

}  // namespace alate::mai2023
