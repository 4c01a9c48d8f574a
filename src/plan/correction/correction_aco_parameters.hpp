// Parameters and presets of correction-aco.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> correction_aco_parameters();
std::vector<Preset> correction_aco_presets();

}  // namespace alate
