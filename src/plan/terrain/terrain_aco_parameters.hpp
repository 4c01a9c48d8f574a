// Parameters and presets of terrain-aco.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> terrain_aco_parameters();
std::vector<Preset> terrain_aco_presets();

}  // namespace alate
