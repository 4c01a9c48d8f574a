// A flight over given points with a smallest turn radius.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "alate/core/scenario.hpp"
#include "alate/data/site.hpp"
#include "space/turning_leg.hpp"

namespace alate {

/// How the flight is to turn.
struct TurnRule {
  TurnModel model = TurnModel::arc_tangent;
  double radius_m = 0;
  std::optional<Vec3> heading;  ///< At the start, unit; without it the flight begins straight.
};

/// As the site asks. It must have navigation.
TurnRule turn_rule(const Site& site);

/// One leg to each point but the first; fewer where the next one cannot be flown.
struct TurningFlight {
  std::vector<TurningLeg> legs;
  double length_m = 0;
};

/// Over the points in order. In the model of free headings those at interior points are bettered until each halves the
/// turn there, its arcs before and after the point equal and in one plane: the length is stationary then, since it
/// changes with the heading at the end of an arc of angle b by r (1 - cos b), in the plane of the arc (costate of the
/// shortest curves of bounded curvature; Sussmann 1995). The optimum so found is a local one. Never longer than with
/// arc and tangent, which is a flight with free headings, too, and is taken where no other is found.
TurningFlight fly_over(std::span<const Vec3> points, const TurnRule& rule);

}  // namespace alate
