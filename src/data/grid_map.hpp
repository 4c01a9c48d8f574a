// Maps of the Moving AI path-finding benchmarks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/data/height_grid.hpp"

namespace alate {

/// Reads a `.map` file (Sturtevant 2012): the header lines `type octile`, `height H`, `width W` and `map`, then H rows
/// of W letters; line ends LF or CRLF. `.`, `G` and `S` (swamp) are free, `@`, `O`, `T` and `W` (water) blocked. Flat,
/// cells 1 m wide. Nothing, and every fault with its line and column, where the file is anything else.
std::optional<HeightGrid> read_grid_map(const std::string& file, std::vector<Fault>& faults);

}  // namespace alate
