// The choice of the metric frame.
#pragma once

#include <optional>

#include "alate/core/frame.hpp"
#include "alate/core/scenario.hpp"
#include "data/given_points.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// The frame a scenario asks for. `auto` is the UTM zone of the midpoint of start and goal, or a local frame where no
/// place and no point has a latitude. Nothing, and a fault at `frame`, if there is none.
std::optional<Frame> choose_frame(const Scenario& scenario, const GivenPoints& points, SiteFaults& faults);

/// A frame whose metres are not metres on the ground (Web Mercator) would bend every limit of the aircraft.
void judge_scale(const Frame& frame, const Vec2& start, SiteFaults& faults);

}  // namespace alate
