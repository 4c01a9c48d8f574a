// The version of the library that was built, not of the header that was read.
#pragma once

#include <string>

namespace alate {

/// "0.1.0".
std::string version();

}  // namespace alate
