// Costs that no route can undercut, valid for the continuous problem and not only for one lattice.
#pragma once

#include "alate/data/site.hpp"

namespace alate {

/// Physical model: the straight line to the goal's ball, no shorter than the climb or descent that is needed allows
/// at the steepest angle, plus the price of the ascent that is needed. Exposure is never negative.
double physical_bound(const Site& site, const Vec3& from);

/// konatowski2019: fuel * sum over i = 1..m of max(0, d - i s), m = ceil((d - tolerance) / s), at distance d: no
/// step brings the aircraft more than s closer. Closed form.
double node_bound(double distance_m, double fuel, double step_m, double tolerance_m);

/// konatowski2019 from the start, with the turn limit. After k steps, for every unit vector n,
/// |goal - node_k| >= n.(goal - start) - sum_{i<=k} s cos(max(0, angle(n, heading) - i delta)),
/// as no leg i can point more than i * delta away from the first heading. The best n lies in the plane of heading
/// and goal; it is searched on a grid, and every n gives a valid bound. The sum over k runs until the bound is within
/// the tolerance. The paper's case gives 132.61 * fuel.
double turn_limited_node_bound(const Site& site, double largest_turn_rad);

}  // namespace alate
