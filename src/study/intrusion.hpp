// How deep a route goes into a threat.
#pragma once

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

struct Intrusion {
  double along_legs = 0;  ///< Greatest r - d on straight legs; negative: the route stays that far outside.
  double at_nodes = 0;    ///< The same at the ends of legs only, start excluded: all that the paper's cost sees.
};

/// Spheres only; routes of straight legs with two states or more.
Intrusion deepest_intrusion(const Threat& sphere, const Route& route);

}  // namespace alate
