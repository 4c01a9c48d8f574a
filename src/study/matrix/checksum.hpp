// A number that tells texts apart.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace alate {

/// FNV-1a, 64 bits (Fowler, Noll, Vo), as 16 hexadecimal digits. The same on every machine.
std::string checksum(std::string_view text);

}  // namespace alate
