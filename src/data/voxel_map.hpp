// Voxel maps of the Moving AI path-finding benchmarks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/data/voxel_grid.hpp"

namespace alate {

/// By its name (`.3dmap`), or else by how it begins (`voxel `).
bool is_voxel_map(const std::string& file);

/// Reads a `.3dmap` file (Brewer and Sturtevant 2018): `voxel X Y Z`, then `x y z` of one blocked cell a line, counted
/// from 0; line ends LF or CRLF. All other cells are free; a cell may be named twice. Cells 1 m wide. Nothing, and
/// every fault with its line and column, where the file is anything else.
std::optional<VoxelGrid> read_voxel_map(const std::string& file, std::vector<Fault>& faults);

}  // namespace alate
