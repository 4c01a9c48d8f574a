#include "plan/colony_parameters.hpp"

#include <utility>

namespace alate {

Parameter ants_parameter(std::int64_t ants, std::string source) {
  return {.name = "ants",
          .default_value = ants,
          .min = 1,
          .max = 100000,
          .help = "Walks an iteration.",
          .source = std::move(source)};
}

Parameter iterations_parameter(std::int64_t iterations, std::string source) {
  return {.name = "iterations",
          .default_value = iterations,
          .min = 1,
          .max = 1e9,
          .help = "Iterations where neither a budget nor a time limit is given.",
          .source = std::move(source)};
}

Parameter spread_parameter(double spread) {
  return {.name = "spread",
          .default_value = spread,
          .min = 1,
          .max = 1e6,
          .help = "Goal-directed: the first ant has the temperature, the last one this many times less.",
          .source = "alate"};
}

Parameter follow_parameter(double share) {
  return {.name = "follow",
          .default_value = share,
          .min = 0,
          .max = 1,
          .help = "Share of ants that begin with a random part of the best route so far.",
          .source = "Wiesemann, Stuetzle 2006 (iterated ants)"};
}

Parameter give_up_parameter(double share) {
  return {.name = "give_up",
          .default_value = share,
          .min = 0,
          .max = 1e6,
          .help =
              "An ant ends where its cost and the estimated rest are dearer than the best so far by this share; "
              "0: never.",
          .source = "alate"};
}

Parameter step_backs_parameter(std::int64_t most) {
  return {.name = "step_backs",
          .default_value = most,
          .min = 0,
          .max = 1e6,
          .help = "An ant without choices takes its last move back, at most this often; 0: it ends.",
          .source = "alate"};
}

Parameter alpha_parameter(std::string source) {
  return {.name = "alpha",
          .default_value = std::int64_t{1},
          .min = 0,
          .max = 16,
          .help = "Power of the trail; 0: trails count for nothing.",
          .source = std::move(source)};
}

Parameter evaporation_parameter(double share, std::string source) {
  return {.name = "evaporation",
          .default_value = share,
          .min = 0,
          .max = 1,
          .above_min = true,
          .help = "Share of a trail that evaporates an iteration.",
          .source = std::move(source)};
}

Parameter trail_ratio_parameter() {
  return {.name = "trail_ratio",
          .default_value = 20.0,
          .min = 1,
          .max = 1e6,
          .help = "max-min: greatest over least trail.",
          .source = "Stuetzle, Hoos 2000, section 2.3"};
}

Parameter best_every_parameter() {
  return {.name = "best_every",
          .unit = "iterations",
          .default_value = std::int64_t{3},
          .min = 0,
          .max = 1e9,
          .help = "max-min: every so often the best so far deposits instead of the iteration's best; 0: never.",
          .source = "Stuetzle, Hoos 2000, section 2.2"};
}

}  // namespace alate
