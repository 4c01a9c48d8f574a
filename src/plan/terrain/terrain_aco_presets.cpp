// The presets of terrain-aco: rows of values.
#include "plan/parameter_values.hpp"
#include "plan/terrain/terrain_aco_parameters.hpp"

namespace alate {

namespace {

/// What both colonies of the paper share. Of these only the lattice along x is the paper's; all numbers are ours.
std::map<std::string, ParamValue> papers(std::map<std::string, ParamValue> values) {
  values.merge(std::map<std::string, ParamValue>{{"main_direction", word("auto")},
                                                 {"join", word("any")},
                                                 {"dead_ends", word("kept")},
                                                 {"safe_height_m", 100.0},
                                                 {"pitch_max_deg", 45.0},
                                                 {"turn_max_deg", 60.0},
                                                 {"fitness", word("paper")},
                                                 {"ants", whole(30)},
                                                 {"iterations", whole(500)},
                                                 {"heuristic", word("smd")},
                                                 {"follow", 0.0},
                                                 {"local_search", word("none")},
                                                 {"polish", word("none")},
                                                 {"evaporation", 0.2},
                                                 {"q", 100.0}});
  return values;
}

}  // namespace

std::vector<Preset> terrain_aco_presets() {
  return {
      {.name = "improved",
       .help = "MAX-MIN Ant System for the scenario's objective along the straight line; good routes are pulled taut."},
      {.name = "mai2023",
       .help = "Mai et al. 2023: S M D, scheduled q0 and an update of the iteration's best path alone; parameters "
               "that the paper was not read for are ours.",
       .values = papers({{"q0", 0.9},
                         {"q0_schedule", word("paper")},
                         {"deposit", word("dual")},
                         {"evaporation_scope", word("path")}})},
      {.name = "aco",
       .help = "The baseline of Mai et al. 2023: choice by chance alone, all ants deposit; with S M D (ours, unknown).",
       .values = papers({{"deposit", word("ant-system")}})}};
}

}  // namespace alate
