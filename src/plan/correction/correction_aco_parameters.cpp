#include "plan/correction/correction_aco_parameters.hpp"

#include "plan/colony_parameters.hpp"
#include "plan/correction/correction_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> walk_parameters() {
  return {
      ants_parameter(30, "alate"),
      iterations_parameter(150, "alate"),
      {.name = "step_limit",
       .unit = "points",
       .default_value = whole(1000),
       .min = 1,
       .max = 1e6,
       .help = "Longest walk.",
       .source = "alate"},
      {.name = "temperature",
       .unit = "m",
       .default_value = 4000.0,
       .min = 0,
       .max = 1e9,
       .above_min = true,
       .help = "A choice that makes the way this much longer is e times less likely.",
       .source = "alate"},
      spread_parameter(20),
      follow_parameter(0.5),
      give_up_parameter(0.05),
      step_backs_parameter(50),
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      alpha_parameter("Dorigo, Maniezzo, Colorni 1996, eq. (4)"),
      {.name = "deposit",
       .default_value = word("max-min"),
       .choices = {"max-min", "ant-system"},
       .help = "Who leaves pheromone: the best ant, within bounds; or all that arrived.",
       .source = "max-min: Stuetzle, Hoos 2000; ant-system: Dorigo, Maniezzo, Colorni 1996"},
      evaporation_parameter(0.1, "Dorigo, Maniezzo, Colorni 1996, eq. (1), 1 - rho"),
      {.name = "q",
       .unit = "m",
       .default_value = 1e5,
       .min = 0,
       .max = 1e12,
       .above_min = true,
       .help = "An ant with a route of cost F leaves q / F.",
       .source = "Dorigo, Maniezzo, Colorni 1996, eq. (2), Q"},
      trail_ratio_parameter(),
      best_every_parameter(),
      {.name = "local_search",
       .default_value = word("windows"),
       .choices = {"windows", "none"},
       .help = "What is done to the best ant of an iteration: stretches of a few points are replaced.",
       .source = "alate"},
  };
}

}  // namespace

std::vector<Parameter> correction_aco_parameters() {
  std::vector<Parameter> all = walk_parameters();
  for (const auto& part : {trail_parameters(), window_parameters(), choice_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<Preset> correction_aco_presets() {
  return {{.name = "mmas", .help = "MAX-MIN Ant System with local search, made good."},
          {.name = "as",
           .help = "Plain Ant System: all ants deposit, none follows another, no local search.",
           .values = {{"deposit", word("ant-system")},
                      {"local_search", word("none")},
                      {"follow", 0.0},
                      {"give_up", 0.0},
                      {"spread", 1.0},
                      {"temperature", 1500.0},
                      {"evaporation", 0.5},
                      {"iterations", whole(200)}}}};
}

}  // namespace alate
