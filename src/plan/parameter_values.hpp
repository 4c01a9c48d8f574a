// Values of parameters, in the types that a ParamTable tells apart.
#pragma once

#include <cstdint>
#include <string>

namespace alate {

inline std::int64_t whole(std::int64_t value) { return value; }
inline std::string word(const char* text) { return text; }

}  // namespace alate
