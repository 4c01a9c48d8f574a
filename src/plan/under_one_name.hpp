// One planner for several spaces.
#pragma once

#include <vector>

#include "alate/plan/registry.hpp"

namespace alate {

/// A planner on one space, and whose sites it serves; the refusal of the part that a site is for is the one told.
struct SpacePart {
  bool (*is_for)(const Site&) = nullptr;  ///< Not asked of the last part.
  PlannerEntry entry;
};

/// The parts as one planner, which does on each site what the first part does that the site is for, or the last part if
/// none is. Name and presets are the first part's; abilities hold where one part has them (deterministic: all), and
/// parameters of all parts can be set.
PlannerEntry under_one_name(std::vector<SpacePart> parts);

}  // namespace alate
