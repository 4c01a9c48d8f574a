// The planners among voxels, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry voxel_jps_entry();
PlannerEntry voxel_astar_entry();
PlannerEntry voxel_theta_star_entry();

bool is_among_voxels(const Site& site);

}  // namespace alate
