#include "plan/correction_aco_parameters.hpp"

#include "plan/correction_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> walk_parameters() {
  return {
      {.name = "ants",
       .default_value = whole(30),
       .min = 1,
       .max = 100000,
       .help = "Walks an iteration.",
       .source = "alate"},
      {.name = "iterations",
       .default_value = whole(150),
       .min = 1,
       .max = 1e9,
       .help = "Iterations where neither a budget nor a time limit is given.",
       .source = "alate"},
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
      {.name = "spread",
       .default_value = 20.0,
       .min = 1,
       .max = 1e6,
       .help = "The first ant has the temperature, the last one this many times less.",
       .source = "alate"},
      {.name = "follow",
       .default_value = 0.5,
       .min = 0,
       .max = 1,
       .help = "Share of ants that begin with a random part of the best route so far.",
       .source = "Wiesemann, Stuetzle 2006 (iterated ants)"},
      {.name = "give_up",
       .default_value = 0.05,
       .min = 0,
       .max = 1e6,
       .help =
           "An ant ends where its way and the relaxed rest are longer than the best so far by this share; 0: never.",
       .source = "alate"},
      {.name = "step_backs",
       .default_value = whole(50),
       .min = 0,
       .max = 1e6,
       .help = "An ant without choices takes its last move back, at most this often; 0: it ends.",
       .source = "alate"},
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      {.name = "alpha",
       .default_value = whole(1),
       .min = 0,
       .max = 16,
       .help = "Power of the trail, which lies on points; 0: trails count for nothing.",
       .source = "Dorigo, Maniezzo, Colorni 1996, eq. (4)"},
      {.name = "deposit",
       .default_value = word("max-min"),
       .choices = {"max-min", "ant-system"},
       .help = "Who leaves pheromone: the best ant, within bounds; or all that arrived.",
       .source = "max-min: Stuetzle, Hoos 2000; ant-system: Dorigo, Maniezzo, Colorni 1996"},
      {.name = "evaporation",
       .default_value = 0.1,
       .min = 0,
       .max = 1,
       .above_min = true,
       .help = "Share of a trail that evaporates an iteration.",
       .source = "Dorigo, Maniezzo, Colorni 1996, eq. (1), 1 - rho"},
      {.name = "q",
       .unit = "m",
       .default_value = 1e5,
       .min = 0,
       .max = 1e12,
       .above_min = true,
       .help = "An ant with a route of cost F leaves q / F.",
       .source = "Dorigo, Maniezzo, Colorni 1996, eq. (2), Q"},
      {.name = "trail_ratio",
       .default_value = 20.0,
       .min = 1,
       .max = 1e6,
       .help = "max-min: greatest over least trail.",
       .source = "Stuetzle, Hoos 2000, section 2.3"},
      {.name = "best_every",
       .unit = "iterations",
       .default_value = whole(3),
       .min = 0,
       .max = 1e9,
       .help = "max-min: every so often the best so far deposits instead of the iteration's best; 0: never.",
       .source = "Stuetzle, Hoos 2000, section 2.2"},
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
