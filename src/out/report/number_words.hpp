// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace alate {

/// About three significant digits and all digits before the point, thousands apart, with the unit: "29 157 m",
/// "1.34°". A dash for what is not a finite number.
std::string quantity(double value, std::string_view unit);

/// "1 234 567".
std::string whole(std::uint64_t count);

}  // namespace alate
