// Parameters and presets of grid-aco.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> grid_aco_parameters();
std::vector<Preset> grid_aco_presets();

}  // namespace alate
