// The best trade-offs of length, corrections and chance of success.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate {

/// Drawing and table; empty without a front.
std::string front_figure(const Result& result);

}  // namespace alate
