// From a list of correction points to the route that is flown through them.
#pragma once

#include <span>
#include <string>

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"
#include "space/turning_leg.hpp"

namespace alate {

/// Appends the states of one leg, which begins where the route ends: its turns as arcs, its straight piece between.
void append_leg(Route& route, const TurningLeg& leg, double radius_m, const Vec3& to);

struct RouteThrough {
  Route route;      ///< Empty if it cannot be flown.
  std::string why;  ///< Then: which leg, in plain words.
};

/// Start, the points with these ids in order, goal; straight legs, or arc and tangent where the site's turn model is
/// arc_tangent (the first leg is straight). Limits of the errors are not judged: `check` does. The site must have
/// navigation; free headings are not decided by the points alone and cannot be had here.
RouteThrough route_through(const Site& site, std::span<const int> ids);

}  // namespace alate
