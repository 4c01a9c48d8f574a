#include "alate/plan/registry.hpp"

#include <algorithm>
#include <cassert>

#include "plan/attitude/attitude_planners.hpp"
#include "plan/correction/correction_planners.hpp"
#include "plan/flight/flight_planners.hpp"
#include "plan/grid/grid_planners.hpp"
#include "plan/grid/voxel_planners.hpp"
#include "plan/terrain/terrain_planners.hpp"
#include "plan/under_one_name.hpp"

namespace alate {

const Preset* PlannerEntry::find_preset(std::string_view preset) const {
  const auto found = std::ranges::find(presets, preset, &Preset::name);
  return found == presets.end() ? nullptr : &*found;
}

void Registry::add(PlannerEntry entry) {
  assert(find(entry.name) == nullptr && !entry.presets.empty());
  entries_.push_back(std::move(entry));
}

const PlannerEntry* Registry::find(std::string_view name) const {
  const auto found = std::ranges::find(entries_, name, &PlannerEntry::name);
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> names;
  for (const PlannerEntry& entry : entries_) names.push_back(entry.name);
  return names;
}

namespace {

bool drifts(const Site& site) { return site.navigation.has_value(); }

}  // namespace

const Registry& builtin_planners() {
  static const Registry kRegistry = [] {
    Registry registry;
    registry.add(under_one_name(interval_astar_entry(), {{.is_for = drifts, .entry = correction_flight_entry()}}));
    registry.add(beam_entry());
    registry.add(greedy_entry());
    registry.add(attitude_aco_entry());
    registry.add(label_setting_entry());
    registry.add(sparse_astar_entry());
    registry.add(correction_ga_entry());
    registry.add(correction_aco_entry());
    registry.add(terrain_aco_entry());
    registry.add(under_one_name(jps_entry(), {{.is_for = is_among_voxels, .entry = voxel_jps_entry()}}));
    registry.add(under_one_name(astar_entry(), {{.is_for = is_over_terrain, .entry = terrain_astar_entry()},
                                                {.is_for = is_among_voxels, .entry = voxel_astar_entry()}}));
    registry.add(under_one_name(theta_star_entry(), {{.is_for = is_over_terrain, .entry = terrain_theta_star_entry()},
                                                     {.is_for = is_among_voxels, .entry = voxel_theta_star_entry()}}));
    registry.add(grid_aco_entry());
    registry.add(primitive_aco_entry());
    return registry;
  }();
  return kRegistry;
}

}  // namespace alate
