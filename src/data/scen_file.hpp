// Tasks of the Moving AI path-finding benchmarks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/core/fault.hpp"
#include "alate/data/height_grid.hpp"
#include "alate/data/voxel_grid.hpp"

namespace alate {

/// One row: from cell to cell, and the length of the shortest way as published. (0, 0) is the upper left.
struct ScenRow {
  int start_column = 0, start_row = 0;
  int goal_column = 0, goal_row = 0;
  double optimum = 0;  ///< Cell sides.
};

/// A map and its tasks, in the order of the file.
struct ScenFile {
  HeightGrid grid;
  std::vector<ScenRow> rows;
};

/// As above, among voxels.
struct VoxelScenRow {
  VoxelCell start{};
  VoxelCell goal{};
  double optimum = 0;  ///< Cell sides.
};

struct VoxelScenFile {
  VoxelGrid voxels;
  std::vector<VoxelScenRow> rows;
};

/// By how much a length may differ from a published one and still be equal: 1e-3 (some files carry few decimals), or
/// half a unit of the sixth significant digit where that is more, as files written with six digits round to it.
double scen_tolerance(double published);

/// Reads a `.map.scen` file (Sturtevant 2012) and the map beside it that its rows name: `version 1`, then bucket, map,
/// width, height, start column and row, goal column and row, optimal length, apart by tabs or blanks; line ends LF or
/// CRLF. Nothing, and every fault with its line, where a file is anything else: an unknown version, missing columns,
/// rows of another map or size, ends outside the map or in blocked cells.
std::optional<ScenFile> read_scen_file(const std::string& file, std::vector<Fault>& faults);

/// Reads a `.3dmap.3dscen` file (Brewer and Sturtevant 2018) and the map beside it: `version 1`, the name of the map,
/// then x, y and z of start and goal, optimal length, and its ratio to that of the shortest way were all cells free; as
/// above.
std::optional<VoxelScenFile> read_voxel_scen_file(const std::string& file, std::vector<Fault>& faults);

}  // namespace alate
