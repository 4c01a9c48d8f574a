#include "plan/terrain_aco_parameters.hpp"

#include "plan/colony_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> lattice_parameters() {
  return {
      {.name = "main_direction",
       .default_value = word("line"),
       .choices = {"line", "auto", "x", "y"},
       .help = "Every move leads one step this way; line: straight from start to goal; auto: x or y, the longer side.",
       .source = "x: Mai et al. 2023, section 2 (verbatim); line, auto: alate"},
      {.name = "step_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e7,
       .help = "Step in the main direction; 0: a fiftieth of the way. Rounded so that whole steps lead to the goal.",
       .source = "alate: not recovered from Mai et al. 2023"},
      {.name = "side_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e7,
       .help = "Step sideways; 0: as in the main direction; along the line half of that, unless so narrow a window "
               "leads nowhere.",
       .source = "alate: not recovered from Mai et al. 2023"},
      {.name = "height_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e6,
       .help = "Step upwards; 0: a fifth of the main step, less where climb limits or the band ask for it.",
       .source = "alate: not recovered from Mai et al. 2023"},
      {.name = "window_side",
       .unit = "cells",
       .default_value = whole(2),
       .min = 1,
       .max = 2,
       .help = "Most cells sideways in one move.",
       .source = "alate: unresolved in Mai et al. 2023; 2 in the teaching example it comes from"},
      {.name = "window_height",
       .unit = "cells",
       .default_value = whole(2),
       .min = 1,
       .max = 2,
       .help = "Most cells up or down in one move.",
       .source = "alate: unresolved in Mai et al. 2023; 2 in the teaching example it comes from"},
  };
}

std::vector<Parameter> leg_parameters() {
  return {
      {.name = "join",
       .default_value = word("window"),
       .choices = {"window", "any"},
       .help = "The last leg, to the goal, keeps to the window, or may be any that is free.",
       .source = "any: Mai et al. 2023, Algorithm 1 (reconstructed); window: alate"},
      {.name = "safety",
       .default_value = word("leg"),
       .choices = {"leg", "node"},
       .help = "S = 1 asks that the whole leg be free, or its end alone; routes that hit the ground then count as "
               "collisions and are never the best.",
       .source = "Mai et al. 2023, eq. (11), leaves it open"},
      {.name = "safe_height_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e5,
       .help = "h_s, least height of a node above ground; terrain.clearance_m holds in any case.",
       .source = "Mai et al. 2023, eq. (11) (verbatim, h_s not recovered)"},
      {.name = "dead_ends",
       .default_value = word("pruned"),
       .choices = {"pruned", "kept"},
       .help = "Moves that lead to dead ends only are taken away beforehand, or ants walk into them and are dropped.",
       .source = "pruned: alate; kept: Mai et al. 2023 tell of no remedy"},
  };
}

std::vector<Parameter> constraint_parameters() {
  return {
      {.name = "constraints",
       .default_value = word("filter"),
       .choices = {"filter", "penalty"},
       .help = "Constraints (1) to (5) take candidates away, or each break adds to the score. What the scenario limits "
               "is kept in any case.",
       .source = "alate: Mai et al. 2023 leave it open"},
      {.name = "penalty",
       .default_value = 100.0,
       .min = 0,
       .max = 1e12,
       .help = "penalty: added to the score for each constraint broken.",
       .source = "alate"},
      {.name = "length_max_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e9,
       .help = "L_max, longest route; 0: no limit but vehicle.range_m.",
       .source = "Mai et al. 2023, (1), eq. (2) (reconstructed)"},
      {.name = "leg_min_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e7,
       .help = "l_min, shortest leg.",
       .source = "Mai et al. 2023, (2), eq. (3) (reconstructed)"},
      {.name = "height_min_agl_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e5,
       .help = "h_min, least height of a node above ground; 0: as the terrain's clearance_m says.",
       .source = "Mai et al. 2023, (3), eq. (4) (verbatim, value not recovered)"},
      {.name = "height_max_m",
       .unit = "m",
       .default_value = 0.0,
       .min = 0,
       .max = 1e5,
       .help = "h_max, greatest height of a node above the sea; 0: as the terrain's ceilings say.",
       .source = "Mai et al. 2023, (3), eq. (4) (verbatim, value not recovered)"},
      {.name = "pitch_max_deg",
       .unit = "deg",
       .default_value = 90.0,
       .min = 0,
       .max = 90,
       .help = "theta_max, steepest leg either way.",
       .source = "Mai et al. 2023, (4), eq. (5) (partly read, value not recovered)"},
      {.name = "turn_max_deg",
       .unit = "deg",
       .default_value = 180.0,
       .min = 0,
       .max = 180,
       .help = "phi_max, sharpest turn between two legs, seen from above.",
       .source = "Mai et al. 2023, (5), eq. (6) (reconstructed, value not recovered)"},
  };
}

std::vector<Parameter> score_parameters() {
  return {
      {.name = "fitness",
       .default_value = word("objective"),
       .choices = {"objective", "paper"},
       .help =
           "What routes are ranked by, and what the history tells: the scenario's objective; or F = w1 C_0 + w2 C_h + "
           "w3 C_theta. The cost of the result is the scenario's objective in any case.",
       .source = "paper: Mai et al. 2023, eqs. (20)-(23) (verbatim)"},
      {.name = "weight_length",
       .default_value = 1.0,
       .min = 0,
       .max = 1e9,
       .above_min = true,
       .help = "w1, of the length in km.",
       .source = "Mai et al. 2023, eq. (20) (verbatim, value not recovered)"},
      {.name = "weight_height",
       .default_value = 1.0,
       .min = 0,
       .max = 1e9,
       .help = "w2, of the sum of the heights in km where legs end; their middles would change all routes alike.",
       .source = "Mai et al. 2023, eq. (20) (verbatim, value not recovered)"},
      {.name = "weight_turn",
       .default_value = 1.0,
       .min = 0,
       .max = 1e9,
       .help = "w3, of the sum of angles between legs.",
       .source = "Mai et al. 2023, eq. (20) (verbatim, value not recovered)"},
      {.name = "height_above",
       .default_value = word("sea"),
       .choices = {"sea", "ground"},
       .help = "Datum of h_i.",
       .source = "Mai et al. 2023, eq. (22), leaves it open"},
      {.name = "angle_unit",
       .default_value = word("rad"),
       .choices = {"rad", "deg"},
       .help = "Unit of theta_i.",
       .source = "Mai et al. 2023, eq. (23), leaves it open"},
  };
}

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
  for (const auto& part :
       {lattice_parameters(), leg_parameters(), constraint_parameters(), score_parameters(), heuristic_parameters(),
        transition_parameters(), improvement_parameters(), trail_parameters(), dual_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace alate
