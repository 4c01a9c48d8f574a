// Planners that search voxel maps: from cell to cell, proven, and at any angle.
#include "plan/grid/grid_exact.hpp"
#include "plan/grid/voxel_plan.hpp"
#include "plan/grid/voxel_planners.hpp"
#include "search/voxel/voxel_astar.hpp"
#include "search/voxel/voxel_jps.hpp"
#include "search/voxel/voxel_theta.hpp"

namespace alate {

namespace {

template <class Search, class Legs>
PlannerEntry entry(std::string_view name, std::string_view help) {
  return {.name = std::string(name),
          .help = std::string(help),
          .can = {.exact = Legs::kProven, .deterministic = true, .voxels = true, .space = "voxel map"},
          .presets = {{.name = "default", .help = "It has no parameters."}},
          .parameters = ParamTable(std::vector<Parameter>{}),
          .refuses = voxel_refusal,
          .make = [](const ParamValues&) { return Planner(CellExact<Search, Legs>()); }};
}

}  // namespace

PlannerEntry voxel_jps_entry() {
  return entry<VoxelJps, VoxelToVoxel>(
      "jps", "Among voxels likewise, in 26 directions (Nobes, Harabor, Wybrow and Walsh 2022).");
}

PlannerEntry voxel_astar_entry() {
  return entry<VoxelAStar, VoxelToVoxel>("astar", "Among voxels likewise, in 26 directions.");
}

PlannerEntry voxel_theta_star_entry() {
  return entry<VoxelTheta, VoxelLines>("theta-star",
                                       "Among voxels Lazy Theta* (Nash, Koenig and Tovey 2010): short, never longer "
                                       "than from cell to cell, but not proven the shortest.");
}

bool is_among_voxels(const Site& site) { return site.voxels.has_value(); }

}  // namespace alate
