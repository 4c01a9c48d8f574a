// The grid of a scenario, and places on it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "alate/data/height_grid.hpp"
#include "data/site_faults.hpp"

namespace alate {

/// Reads or draws `scenario.grid`; nothing, and faults, where the map cannot be read.
std::optional<HeightGrid> read_grid(const Scenario& scenario, SiteFaults& faults);

/// Centre of `cell`; nothing, and a fault at `field`, where it is blocked or outside.
std::optional<Vec3> locate_cell(const HeightGrid& grid, const std::array<int, 2>& cell, const std::string& field,
                                SiteFaults& faults);

}  // namespace alate
