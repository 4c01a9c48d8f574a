#include "plan/correction/correction_parameters.hpp"

namespace alate {

std::vector<Parameter> choice_parameters() {
  return {
      {.name = "candidates",
       .unit = "points",
       .default_value = std::int64_t{128},
       .min = 1,
       .max = 100000,
       .help = "Points to choose from at each step: those with the shortest leg plus rest of the way.",
       .source = "alate"},
      {.name = "corridor",
       .default_value = 2.0,
       .min = 0,
       .max = 1e6,
       .help =
           "Only points in the ellipsoid about start and goal whose ways are this many times the shortest that errors "
           "might allow; 0: all.",
       .source = "alate"},
  };
}

std::vector<Parameter> window_parameters() {
  return {
      {.name = "window_old",
       .unit = "points",
       .default_value = std::int64_t{3},
       .min = 0,
       .max = 10,
       .help = "Local search takes up to so many neighbouring points out",
       .source = "alate"},
      {.name = "window_new",
       .unit = "points",
       .default_value = std::int64_t{2},
       .min = 0,
       .max = 4,
       .help = "and puts up to so many in.",
       .source = "alate"},
  };
}

}  // namespace alate
