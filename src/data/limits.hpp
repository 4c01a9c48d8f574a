// Sizes beyond which an input is refused. docs/limits.md lists them.
#pragma once

#include <cstdint>

namespace alate::limits {

inline constexpr std::int64_t kRasterCells = 150'000'000;
/// Heights outside these are no ground on Earth but voids that nobody marked as such.
inline constexpr double kLowestGround_m = -12'000;
inline constexpr double kHighestGround_m = 9'000;

}  // namespace alate::limits
