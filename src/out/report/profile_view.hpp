// The height profile of the report.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate {

/// Figure with drawing and legend; empty for a route of fewer than two states.
std::string profile_figure(const Result& result);

}  // namespace alate
