// Places of a scenario, brought into the frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/data/site.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// The position of `place`; nothing, and a fault at `field`, if it has none in this frame or no height.
std::optional<Vec3> locate(const Site& site, const PlaceSpec& place, const std::string& field, SiteFaults& faults);

/// All threats that have a place, in the order of the scenario.
std::vector<Threat> locate_threats(const Site& site, SiteFaults& faults);

/// Faults for a start or goal that no flight may begin or end at.
void judge_place(const Site& site, const Vec3& position, const std::string& field, SiteFaults& faults);

}  // namespace alate
