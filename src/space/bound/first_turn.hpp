// Proof that a start leads into something closer than a turn.
//
// An aircraft that turns on circles of radius R or wider has, after s metres seen from above (s <= R pi/2), a heading
// within s/R of the first one. So it has come at least R sin(s/R) ahead, and at most R (1 - cos(s/R)) aside: whatever
// it does, it crosses the line x ahead, x <= R, within R - sqrt(R^2 - x^2) of the middle, after at most R asin(x/R)
// metres. Where nothing is open there at the altitudes that can be had by then, there is no flight.
#pragma once

#include <optional>

#include "alate/world/problem.hpp"
#include "space/bound/open_air.hpp"

namespace alate {

struct Dead {
  Vec2 where = Vec2::Zero();  ///< Middle of the line that cannot be crossed.
  double ahead_m = 0;
};

/// Nothing where no such proof is found. Needs ground and a turn radius.
std::optional<Dead> dead_ahead(const Problem& problem, Voids voids);

}  // namespace alate
