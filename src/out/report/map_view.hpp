// The map of the report: ground from above, threats, the route and the straight line it replaces.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate {

/// Figure with drawing, legend and caption.
std::string map_figure(const Result& result);

}  // namespace alate
