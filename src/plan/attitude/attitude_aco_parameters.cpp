#include "plan/attitude/attitude_aco_parameters.hpp"

#include "plan/attitude/attitude_plan.hpp"
#include "plan/colony_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> walk_parameters() {
  return {
      ants_parameter(40, "alate: the paper leaves it open"),
      iterations_parameter(30, "konatowski2019: 180, section 4"),
      step_limit_parameter(),
      {.name = "heuristic",
       .default_value = word("goal-directed"),
       .choices = {"goal-directed", "1/J"},
       .help = "How good a choice looks: by its own cost J and the estimated cost h from there to the goal, or by "
               "(1/J)^beta alone.",
       .source = "1/J: Konatowski, Pawlowski 2019, eq. (1); goal-directed: alate"},
      {.name = "beta",
       .default_value = whole(3),
       .min = 0,
       .max = 16,
       .help = "Power of 1/J.",
       .source = "Konatowski, Pawlowski 2019, eq. (1), beta"},
      {.name = "temperature",
       .unit = "steps",
       .default_value = 0.06,
       .min = 0,
       .max = 1e6,
       .above_min = true,
       .help = "Goal-directed: a choice that costs as much as this many steps more is e times less likely.",
       .source = "alate"},
      spread_parameter(30),
      follow_parameter(0.8),
      give_up_parameter(0.02),
      step_backs_parameter(1000),
      {.name = "overshoot",
       .default_value = word("fly-on"),
       .choices = {"fly-on", "end"},
       .help = "An ant that was under two steps from the goal and moves away flies on until the step limit, or ends at "
               "the node before. There it leaves pheromone as if it had arrived; only within the tolerance is it a "
               "route.",
       .source = "alate: Konatowski, Pawlowski 2019 leave it open"},
      {.name = "threats_at",
       .default_value = word("nodes"),
       .choices = {"nodes", "legs"},
       .help = "Under the konatowski2019 objective: threat of a step at the node where it ends, or its mean along the "
               "leg, so that no sphere is jumped unseen. With legs the ants minimise another sum than the cost "
               "reported, which is that of nodes; and they are slower, as the leg is priced in double precision.",
       .source = "nodes: Konatowski, Pawlowski 2019, eq. (34); legs: alate"},
      {.name = "q0",
       .default_value = 0.0,
       .min = 0,
       .max = 1,
       .help = "Chance to take the best choice instead of drawing one.",
       .source = "Dorigo, Gambardella 1997, eq. (3)"},
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      alpha_parameter("Konatowski, Pawlowski 2019, eq. (1), alpha"),
      {.name = "trail",
       .default_value = word("cells"),
       .choices = {"cells", "points"},
       .help = "What carries pheromone: cubic cells, or points that agree to 1e-4 m.",
       .source = "points: Konatowski, Pawlowski 2019, eqs. (28), (35); cells: alate"},
      {.name = "trail_cell",
       .unit = "steps",
       .default_value = 0.25,
       .min = 0,
       .max = 100,
       .above_min = true,
       .help = "Edge of a trail cell.",
       .source = "alate"},
      evaporation_parameter(0.2, "Konatowski, Pawlowski 2019, eq. (2), rho"),
      {.name = "deposit",
       .default_value = word("max-min"),
       .choices = {"max-min", "ant-system", "rank", "acs", "none"},
       .help = "Who leaves pheromone, and whether unknown places decay (max-min) or stay at 1.",
       .source = "ant-system: Konatowski, Pawlowski 2019, eqs. (3), (4); rank: Bullnheimer et al. 1999; max-min: "
                 "Stuetzle, Hoos 2000; acs: Dorigo, Gambardella 1997"},
      {.name = "q",
       .default_value = 50.0,
       .min = 0,
       .max = 1e12,
       .above_min = true,
       .help = "An ant of cost J leaves q / J.",
       .source = "Konatowski, Pawlowski 2019, eq. (4), Q"},
      {.name = "rank_w",
       .default_value = whole(6),
       .min = 1,
       .max = 1000,
       .help = "rank: weight of the best so far; w - 1 ants deposit.",
       .source = "Bullnheimer, Hartl, Strauss 1999, eqs. (3), (4)"},
      trail_ratio_parameter(),
      best_every_parameter(),
      {.name = "wear",
       .default_value = 0.1,
       .min = 0,
       .max = 1,
       .help = "acs: share of a trail that a visit wears away.",
       .source = "Dorigo, Gambardella 1997, eq. (5), xi"},
  };
}

std::vector<Parameter> search_parameters() {
  return {
      {.name = "first_route",
       .default_value = word("known"),
       .choices = {"known", "greedy", "none"},
       .help = "What ants may follow before any has arrived: the greedy walk, improved by a few narrow passes of beam "
               "search; the greedy walk alone; or nothing.",
       .source = "Blum 2005 (Beam-ACO)"},
      {.name = "beam_passes",
       .default_value = whole(0),
       .min = 0,
       .max = 10,
       .help = "Passes of beam search before the ants, each counted as an iteration; 0: 3 under the konatowski2019 "
               "objective in open air (1 where the greedy walk does not arrive), 4 elsewhere.",
       .source = "Blum 2005 (Beam-ACO)"},
      {.name = "local_search",
       .default_value = word("action-string"),
       .choices = {"action-string", "none"},
       .help = "What is done to the best ant of an iteration.",
       .source = "alate"},
      {.name = "pair_distance",
       .unit = "moves",
       .default_value = whole(3),
       .min = 0,
       .max = 1000,
       .help = "action-string: two moves at most this far apart are changed together; 0: only one at a time.",
       .source = "alate"},
      {.name = "pair_margin",
       .default_value = 0.0,
       .min = 0,
       .max = 1,
       .help = "action-string: pairs are tried on routes at most this share dearer than the best so far.",
       .source = "alate"},
  };
}

using Values = std::map<std::string, ParamValue>;

/// The published rule, with what `changes` says.
Values published(const Values& changes = {}) {
  Values values{{"heuristic", word("1/J")},
                {"beta", whole(3)},
                {"alpha", whole(1)},
                {"trail", word("points")},
                {"evaporation", 0.8},
                {"deposit", word("ant-system")},
                {"q", 50.0},
                {"ants", whole(50)},
                {"iterations", whole(180)},
                {"local_search", word("none")},
                {"step_backs", whole(0)},
                {"follow", 0.0},
                {"give_up", 0.0},
                {"first_route", word("none")}};
  for (const auto& [name, value] : changes) values.insert_or_assign(name, value);
  return values;
}

}  // namespace

std::vector<Parameter> attitude_aco_parameters() {
  std::vector<Parameter> all = walk_parameters();
  for (Parameter& parameter : trail_parameters()) all.push_back(std::move(parameter));
  for (Parameter& parameter : search_parameters()) all.push_back(std::move(parameter));
  return all;
}

std::vector<Preset> attitude_aco_presets() {
  return {
      {.name = "guided", .help = "Looks ahead to the goal, MAX-MIN trails on cells, local search on the actions."},
      {.name = "konatowski2019", .help = "Ant System as published.", .values = published()},
      {.name = "konatowski2019-rank",
       .help = "The published rule with rank-based deposits, the paper's own next step.",
       .values = published({{"deposit", word("rank")}})},
      {.name = "konatowski2019-mmas",
       .help = "The published rule with MAX-MIN trails, the paper's own next step.",
       .values = published({{"deposit", word("max-min")}, {"evaporation", 0.2}})},
      {.name = "acs",
       .help = "Ant Colony System with the goal-directed heuristic on trail cells.",
       .values = {{"deposit", word("acs")},
                  {"q0", 0.5},
                  {"evaporation", 0.1},
                  {"first_route", word("greedy")},
                  {"local_search", word("none")}}},
      {.name = "no-pheromone",
       .help = "The published walks with tau = 1 always: what pheromone has to beat.",
       .values = published({{"deposit", word("none")}, {"alpha", whole(0)}})},
  };
}

}  // namespace alate
