// A place as a user finds it again.
#pragma once

#include <string>

#include "alate/data/site.hpp"

namespace alate {

/// "latitude 46.80918, longitude 9.80877", or "x 12.0 m, y 3.5 m" in a frame without a place on Earth.
std::string place_name(const Site& site, const Vec2& xy);

}  // namespace alate
