// Parameters and presets of primitive-aco.
#pragma once

#include <vector>

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> primitive_aco_parameters();
std::vector<Preset> primitive_aco_presets();

}  // namespace alate
