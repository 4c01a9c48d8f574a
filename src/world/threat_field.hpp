// Threats along straight legs, in closed form.
#pragma once

#include "alate/core/geometry.hpp"
#include "alate/data/site.hpp"

namespace alate {

/// Integral along the leg of level * max(0, 1 - d/r), metres; d is the distance to the centre of a sphere or to
/// the axis of a cylinder, and only the part of the leg between a cylinder's floor and top counts.
/// Zero for a leg of no length.
double exposure(const Threat& threat, const Segment& leg);

/// Does the leg come closer than the core? A cylinder's floor and top belong to it.
bool enters_core(const Threat& threat, const Segment& leg);

}  // namespace alate
