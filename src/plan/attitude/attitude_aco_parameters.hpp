// Parameters and presets of attitude-aco.
#pragma once

#include <vector>

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> attitude_aco_parameters();
std::vector<Preset> attitude_aco_presets();

}  // namespace alate
