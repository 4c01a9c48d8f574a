// Parameters that heuristic planners on correction points share.
#pragma once

#include <vector>

#include "alate/core/param_table.hpp"

namespace alate {

/// `candidates` and `corridor`.
std::vector<Parameter> choice_parameters();
/// `window_old` and `window_new`.
std::vector<Parameter> window_parameters();

}  // namespace alate
