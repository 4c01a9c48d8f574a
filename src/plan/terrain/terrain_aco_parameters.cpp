#include "plan/terrain/terrain_aco_parameters.hpp"

#include "plan/attitude/lattice_parameters.hpp"
#include "plan/colony_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> heuristic_parameters() {
  return {
      ants_parameter(4, "alate: not recovered from Mai et al. 2023"),
      iterations_parameter(200, "alate: not recovered from Mai et al. 2023"),
      {.name = "heuristic",
       .default_value = word("goal-directed"),
       .choices = {"goal-directed", "smd", "goal-distance"},
       .help = "How good a move looks: exp(-detour / temperature); eta = S M D; or eta = 1 / distance to the goal.",
       .source =
           "goal-directed: alate; smd: Mai et al. 2023, eqs. (11)-(13) (verbatim, P and K cancel); goal-distance: "
           "the textbook's, possibly that of the paper's baseline"},
      {.name = "temperature",
       .unit = "steps",
       .default_value = 0.3,
       .min = 0,
       .max = 1e6,
       .above_min = true,
       .help = "goal-directed: a move with this detour is e times less likely than one without.",
       .source = "alate"},
      {.name = "factor_unit",
       .default_value = word("km"),
       .choices = {"km", "cells"},
       .help = "smd: unit of heights and distances beside the \"1 +\".",
       .source = "Mai et al. 2023, eqs. (12), (13), leave it open; km: section 2"},
      {.name = "unit_step",
       .default_value = word("literal"),
       .choices = {"literal", "step"},
       .help = "smd: the 1 under the first root of eq. (13) is a 1, or the main step.",
       .source = "Mai et al. 2023, eq. (13) (verbatim: 1)"},
  };
}

std::vector<Parameter> transition_parameters() {
  return {
      alpha_parameter("Mai et al. 2023, eq. (7) (verbatim, value not recovered)"),
      {.name = "beta",
       .default_value = whole(2),
       .min = 0,
       .max = 16,
       .help = "smd, goal-distance: power of the heuristic.",
       .source = "Mai et al. 2023, eq. (7) (verbatim, value not recovered)"},
      {.name = "q0",
       .default_value = 0.0,
       .min = 0,
       .max = 1,
       .help = "Chance that an ant takes the heaviest move instead of drawing.",
       .source = "Mai et al. 2023, eq. (14) (reconstructed: Dorigo, Gambardella 1997, eq. (3))"},
      {.name = "q0_schedule",
       .default_value = word("constant"),
       .choices = {"constant", "paper"},
       .help =
           "paper: q0 is what it begins with; it falls to 0.3 of that, jumps to half after 0.7 of the iterations and "
           "rises to 0.8.",
       .source = "Mai et al. 2023, eq. (15) (verbatim, n from 0: ours)"},
      follow_parameter(0.3),
  };
}

std::vector<Parameter> improvement_parameters() {
  return {
      {.name = "local_search",
       .default_value = word("corridor"),
       .choices = {"corridor", "none"},
       .help = "What is done to the best ant of an iteration: the best string of moves within a cell of its own.",
       .source = "alate"},
      {.name = "polish",
       .default_value = word("taut"),
       .choices = {"taut", "none"},
       .help = "What becomes of each new best route: it leaves the lattice and is pulled taut, for the scenario's "
               "objective.",
       .source = "alate"},
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      {.name = "deposit",
       .default_value = word("max-min"),
       .choices = {"max-min", "dual", "ant-system"},
       .help = "Who leaves pheromone, and its bounds; dual: eqs. (16)-(19).",
       .source = "max-min: Stuetzle, Hoos 2000; dual: Mai et al. 2023, section 4 (verbatim); ant-system: eqs. (8)-(10) "
                 "(verbatim)"},
      {.name = "trail_on",
       .default_value = word("edges"),
       .choices = {"edges", "nodes"},
       .help = "Where pheromone lies.",
       .source = "edges: Mai et al. 2023 write tau_ij; nodes: the teaching example it comes from"},
      evaporation_parameter(0.1, "Mai et al. 2023, eqs. (8), (16) (verbatim, value not recovered)"),
      {.name = "evaporation_scope",
       .default_value = word("global"),
       .choices = {"global", "path"},
       .help = "dual: all trails evaporate, or those of the updated path alone.",
       .source = "path: Mai et al. 2023, eq. (16) as printed"},
      {.name = "q",
       .default_value = 1.0,
       .min = 0,
       .max = 1e12,
       .above_min = true,
       .help = "Q, pheromone left by an ant is Q over its fitness (or length).",
       .source = "Mai et al. 2023, eqs. (10), (17) (verbatim, value not recovered)"},
      {.name = "deposit_over",
       .default_value = word("length"),
       .choices = {"length", "fitness"},
       .help = "ant-system: L_k is the length in km, or the fitness.",
       .source = "length: Mai et al. 2023, eq. (10) (inferred)"},
      {.name = "trail_start",
       .default_value = 1.0,
       .min = 0,
       .max = 1e9,
       .above_min = true,
       .help = "tau_0 (max-min sets its own).",
       .source = "alate: not recovered from Mai et al. 2023"},
      {.name = "trail_min",
       .default_value = 0.1,
       .min = 0,
       .max = 1e9,
       .help = "dual: tau_min.",
       .source = "Mai et al. 2023, eq. (18) (verbatim, value not recovered)"},
      {.name = "trail_max",
       .default_value = 10.0,
       .min = 0,
       .max = 1e9,
       .help = "dual: tau_max.",
       .source = "Mai et al. 2023, eq. (18) (verbatim, value not recovered)"},
      trail_ratio_parameter(),
      best_every_parameter(),
  };
}

std::vector<Parameter> dual_parameters() {
  return {
      {.name = "lambda",
       .default_value = 0.5,
       .min = 0,
       .max = 1,
       .help = "dual: weight of the best fitness so far in the deposit, at first.",
       .source = "Mai et al. 2023, eq. (17) (verbatim, value not recovered)"},
      {.name = "lambda_decay",
       .default_value = 0.9,
       .min = 0,
       .max = 1,
       .help = "dual: gamma, lambda is multiplied by it from time to time.",
       .source = "Mai et al. 2023, eq. (19) (verbatim)"},
      {.name = "lambda_every",
       .unit = "iterations",
       .default_value = whole(100),
       .min = 1,
       .max = 1e9,
       .help = "dual: how often lambda decays.",
       .source = "Mai et al. 2023, eq. (19) (verbatim)"},
      {.name = "fitness_current",
       .default_value = word("iteration-best"),
       .choices = {"iteration-best", "each-ant"},
       .help = "dual: the best ant of an iteration updates its path; or each ant that arrives, by its own fitness.",
       .source = "iteration-best: Mai et al. 2023 in words; each-ant: another reading of fit_current in eq. (17)"},
  };
}

}  // namespace

std::vector<Parameter> terrain_aco_parameters() {
  std::vector<Parameter> all;
  for (const auto& part : {lattice_parameters(), heuristic_parameters(), transition_parameters(),
                           improvement_parameters(), trail_parameters(), dual_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace alate
