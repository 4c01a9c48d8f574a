// Height of straight legs above analytic hills: never above the truth, and within 0.05 m of it.
//
// Method: bisection with a bound. Along a leg the ground departs from the chord between two of its points by at
// most (second derivative) length^2 / 8, and a hill's second derivative is bounded by where the leg comes
// closest to its top. Cost: a few evaluations per hill crossed; deep bisection only where ground and leg are close.
#pragma once

#include "alate/core/geometry.hpp"
#include "alate/data/peaks.hpp"

namespace alate {

/// Lowest height above the hills; -infinity where the leg leaves their area.
double clearance(const PeakGround& ground, const Segment& leg);

/// Is the leg everywhere at least `floor` (decided as `clearance` does) and at most `roof` (0.05 m on the safe
/// side) above the hills?
bool within(const PeakGround& ground, const Segment& leg, double floor, double roof);

}  // namespace alate
