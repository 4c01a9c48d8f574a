// The planners on correction points, as the registry lists them.
#pragma once

#include "alate/plan/registry.hpp"

namespace alate {

PlannerEntry label_setting_entry();
PlannerEntry correction_ga_entry();

/// The first `count` chromosomes with which `correction-ga` begins under these parameters and the default seed, as ids,
/// for strings of fixed length (Zhou et al. 2020).
std::vector<std::vector<int>> first_chromosomes(const Problem& problem, const ParamValues& parameters,
                                                std::size_t count);

PlannerEntry sparse_astar_entry();
PlannerEntry correction_aco_entry();

}  // namespace alate
