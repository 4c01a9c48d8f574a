// The presets of grid-aco: rows of values.
#include "plan/grid/grid_aco_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

/// Table 1 of Yin et al. 2021 was not available; it says that the baseline's values were altered by trial. Both presets
/// have the baseline's [C], so that only mu differs.
std::map<std::string, ParamValue> multi_factor_values(std::int64_t mu_power) {
  return {{"ants", whole(50)},
          {"iterations", whole(30)},
          {"diagonal", word("1.4")},
          {"heuristic", word("multi-factor")},
          {"follow", 0.0},
          {"give_up", 0.0},
          {"step_backs", whole(0)},
          {"repeat_best", true},
          {"local_search", word("none")},
          {"weight_height", 100.0},
          {"weight_turns", 1.0},
          {"deposit", word("bounded")},
          {"evaporation", 0.3},
          {"q", 100.0},
          {"trail_start", 20.0},
          {"mu_power", mu_power}};
}

/// The textbook colonies: no local search, no ant follows another or steps back. They see the goal as `improved` does:
/// with eta = 1 / d_jE no ant arrives on maps of 100 x 100 cells.
std::map<std::string, ParamValue> textbook(std::map<std::string, ParamValue> values) {
  values.merge(std::map<std::string, ParamValue>{{"ants", whole(50)},
                                                 {"iterations", whole(100)},
                                                 {"follow", 0.0},
                                                 {"give_up", 0.0},
                                                 {"step_backs", whole(0)},
                                                 {"local_search", word("none")}});
  return values;
}

}  // namespace

std::vector<Preset> grid_aco_presets() {
  return {
      {.name = "improved",
       .help = "MAX-MIN Ant System for length: ants see the goal, step back and follow the best; shortcuts by sight.",
       .values = {{"trail_ratio", 100.0}}},
      {.name = "li2019",
       .help = "Li et al. 2019: several factors in the heuristic, as in its public program.",
       .values = multi_factor_values(0)},
      {.name = "yin2021",
       .help = "Yin et al. 2021: the same with the adaptive factor mu, reconstructed from its prose.",
       .values = multi_factor_values(1)},
      {.name = "as",
       .help = "Ant System: all ants that arrive deposit.",
       .values = textbook({{"deposit", word("ant-system")}, {"evaporation", 0.3}, {"trail_start", 0.1}})},
      {.name = "acs", .help = "Ant Colony System.", .values = textbook({{"deposit", word("acs")}, {"q0", 0.5}})},
      {.name = "rank",
       .help = "Rank-based Ant System.",
       .values = textbook({{"deposit", word("rank")}, {"evaporation", 0.2}, {"trail_start", 0.1}})},
      {.name = "mmas",
       .help = "MAX-MIN Ant System.",
       .values = textbook({{"deposit", word("max-min")}, {"trail_ratio", 100.0}})}};
}

}  // namespace alate
