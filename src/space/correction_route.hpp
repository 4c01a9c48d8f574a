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

/// Start, the points with these ids in order, goal, flown as the site's turn model says (see fly_over). The first leg
/// is straight unless the start's heading is given. Limits of the errors are not judged: `check` does. The site must
/// have navigation.
RouteThrough route_through(const Site& site, std::span<const int> ids);

}  // namespace alate
