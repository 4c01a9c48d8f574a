// Exposure to threats along a leg.
#pragma once

#include "alate/core/route.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Integral along leg `i` of level * max(0, 1 - d/r), metres. d is the distance to a sphere's centre, or to the
/// axis of a cylinder between its floor and top. Straight legs: closed form, from the integral of
/// sqrt(x^2 + q^2) = (x sqrt(x^2 + q^2) + q^2 asinh(x/q)) / 2. Arcs: adaptive Gauss-Kronrod to 1e-7 relative.
double exposure(const Threat& threat, const Route& route, std::size_t i);

/// level * max(0, r - d) at a point (Konatowski and Pawlowski 2019, eq. 34).
double point_exposure(const Threat& threat, const Vec3& at);

}  // namespace alate
