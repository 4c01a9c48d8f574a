// One planner for several spaces.
#pragma once

#include <vector>

#include "alate/plan/registry.hpp"

namespace alate {

/// A planner on one space, and the sites that it is for.
struct SpacePart {
  bool (*is_for)(const Site&) = nullptr;
  PlannerEntry entry;
};

/// All as one planner, which does on each site what the first part does that the site is for, or `main` if none is; so
/// with refusals, and with `can_on`. Name, presets and the first words of the help are those of `main`; abilities hold
/// where one has them (deterministic: all), and parameters of all can be set.
PlannerEntry under_one_name(PlannerEntry main, std::vector<SpacePart> others);

}  // namespace alate
