#include "plan/flight/primitive_aco_parameters.hpp"

#include "plan/colony_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> walk_parameters() {
  return {
      ants_parameter(8, "alate"),
      iterations_parameter(60, "alate: as interval-astar"),
      {.name = "temperature",
       .unit = "bins",
       .default_value = 0.1,
       .min = 0,
       .max = 1e6,
       .above_min = true,
       .help = "A move that costs as much as this many bins of level flight more is e times less likely.",
       .source = "alate"},
      spread_parameter(10),
      {.name = "look_ahead",
       .unit = "turn radii",
       .default_value = 1.0,
       .min = 0,
       .max = 100,
       .help = "How far ahead of the end of a move its guide looks: it knows of places and altitudes, not of headings.",
       .source = "alate"},
      follow_parameter(0.5),
      give_up_parameter(0.1),
      step_backs_parameter(100),
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      alpha_parameter("Dorigo, Maniezzo, Colorni 1996, eq. (4)"),
      evaporation_parameter(0.1, "Stuetzle, Hoos 2000, section 2.1, 1 - rho"),
      trail_ratio_parameter(),
      best_every_parameter(),
  };
}

std::vector<Parameter> search_parameters() {
  return {
      {.name = "first_route",
       .default_value = word("search"),
       .choices = {"search", "none"},
       .help = "What ants start from: the answer of the interval search, bettered, with trails along it; or nothing. "
               "Each search counts as an iteration.",
       .source = "alate"},
      {.name = "local_search",
       .default_value = word("changes"),
       .choices = {"changes", "none"},
       .help = "What is done to the best ant of an iteration: its way is changed piece by piece, as interval-astar "
               "does; ants may then follow it, and it carries trails.",
       .source = "alate"},
      {.name = "trials",
       .default_value = whole(250),
       .min = 1,
       .max = 1e6,
       .help = "changes: tried an iteration.",
       .source = "alate: as interval-astar"},
  };
}

}  // namespace

std::vector<Parameter> primitive_aco_parameters() {
  std::vector<Parameter> all = walk_parameters();
  for (const auto& part : {trail_parameters(), search_parameters()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<Preset> primitive_aco_presets() {
  return {{.name = "guided", .help = "From the answer of the interval search, with its local changes."},
          {.name = "mmas",
           .help = "Plain MAX-MIN Ant System from nothing: no ant follows another, no local search.",
           .values = {{"first_route", word("none")},
                      {"local_search", word("none")},
                      {"ants", whole(30)},
                      {"follow", 0.0},
                      {"give_up", 0.0}}}};
}

}  // namespace alate
