// The navigation errors along the way: they grow with the length flown and fall at each correction.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate {

/// Figure with drawing and legend; empty without navigation or without a route. Every correction is shown to work.
std::string errors_figure(const Result& result);

}  // namespace alate
