// Parameters and presets of correction-ga.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

std::vector<Parameter> correction_ga_parameters();
std::vector<Preset> correction_ga_presets();

}  // namespace alate
