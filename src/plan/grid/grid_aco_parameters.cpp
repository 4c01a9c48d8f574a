#include "plan/grid/grid_aco_parameters.hpp"

#include "plan/colony_parameters.hpp"
#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> walk_parameters() {
  return {
      ants_parameter(32, "alate"),
      iterations_parameter(200, "alate"),
      {.name = "diagonal",
       .default_value = word("sqrt2"),
       .choices = {"sqrt2", "1.4"},
       .help = "Cost of a diagonal step, straight ones cost 1; the cost of the result is always planar length.",
       .source = "1.4: public program for Li et al. 2019 [C]"},
      {.name = "heuristic",
       .default_value = word("goal-directed"),
       .choices = {"goal-directed", "goal-distance", "multi-factor"},
       .help = "How good a move looks: exp(-detour / temperature); (1 / d_jE)^beta; or eqs. (1)-(5), (12).",
       .source = "alate; Dorigo, Maniezzo, Colorni 1996; Yin et al. 2021"},
      {.name = "temperature",
       .unit = "cells",
       .default_value = 0.4,
       .min = 0.0,
       .max = 1e6,
       .above_min = true,
       .help = "goal-directed: a move with this detour is e times less likely than one without.",
       .source = "alate"},
      alpha_parameter("Dorigo, Maniezzo, Colorni 1996, eq. (4)"),
      {.name = "beta",
       .default_value = whole(3),
       .min = 0,
       .max = 16,
       .help = "goal-distance, multi-factor: power of the heuristic.",
       .source = "Yin et al. 2021, eq. (6)"},
      {.name = "q0",
       .default_value = 0.0,
       .min = 0,
       .max = 1,
       .help = "Chance that an ant takes the heaviest move instead of drawing; not for multi-factor.",
       .source = "Dorigo, Gambardella 1997, eq. (3)"},
      follow_parameter(0.3),
      give_up_parameter(0.1),
      step_backs_parameter(whole(1000000)),
      {.name = "repeat_best",
       .default_value = false,
       .help = "Ant 0 repeats the best route so far, is scored and deposits.",
       .source = "public program for Li et al. 2019 [C]"},
      {.name = "local_search",
       .default_value = word("sight"),
       .choices = {"sight", "none"},
       .help =
           "What is done to the best ant of an iteration: stretches are replaced by shortest ones without a detour.",
       .source = "alate"},
      {.name = "reach",
       .unit = "moves",
       .default_value = whole(12),
       .min = 2,
       .max = 64,
       .help = "sight: longest stretch.",
       .source = "alate"},
  };
}

std::vector<Parameter> score_parameters() {
  return {
      {.name = "weight_height",
       .default_value = 0.0,
       .min = 0,
       .max = 1e9,
       .help = "Weight of F, the standard deviation of heights, in the score S = L + F + T that ants are ranked by.",
       .source = "100: public program for Li et al. 2019 [C]"},
      {.name = "weight_turns",
       .default_value = 0.0,
       .min = 0,
       .max = 1e9,
       .help = "Weight of T, the number of turns, in S.",
       .source = "1: public program for Li et al. 2019 [C]"},
      {.name = "heights_of",
       .default_value = word("route"),
       .choices = {"route", "matrix"},
       .help = "F is taken over the cells of the route, as meant; or over as many cells of the height matrix in column "
               "order, as coded.",
       .source = "matrix: public program for Li et al. 2019 [C]"},
  };
}

std::vector<Parameter> trail_parameters() {
  return {
      {.name = "deposit",
       .default_value = word("max-min"),
       .choices = {"max-min", "ant-system", "rank", "acs", "bounded"},
       .help = "Who leaves pheromone, and its bounds.",
       .source = "Stuetzle, Hoos 2000; Dorigo, Maniezzo, Colorni 1996; Bullnheimer, Hartl, Strauss 1999; Dorigo, "
                 "Gambardella 1997; Yin et al. 2021, eqs. (7)-(11)"},
      evaporation_parameter(0.1, "Dorigo, Maniezzo, Colorni 1996, eq. (1), 1 - rho; Yin et al. 2021, eq. (9)"),
      {.name = "q",
       .default_value = 1.0,
       .min = 0,
       .max = 1e12,
       .above_min = true,
       .help = "An ant with a route of score S leaves q / S.",
       .source = "Yin et al. 2021, eq. (7)"},
      {.name = "deposit_over",
       .default_value = word("score"),
       .choices = {"score", "length"},
       .help = "bounded: q is divided by the score, or by the length.",
       .source = "score: public program for Li et al. 2019 [C]; length: prose of Yin et al. 2021"},
      {.name = "trail_start",
       .default_value = 1.0,
       .min = 0,
       .max = 1e9,
       .above_min = true,
       .help = "Trail of a move that no ant took (max-min and acs set their own).",
       .source = "20: public program for Li et al. 2019 [C]"},
      trail_ratio_parameter(),
      best_every_parameter(),
      {.name = "rank_w",
       .default_value = whole(6),
       .min = 1,
       .max = 100000,
       .help = "rank: w, so many ants deposit, the best so far among them.",
       .source = "Bullnheimer, Hartl, Strauss 1999, eq. (3)"},
      {.name = "wear",
       .default_value = 0.1,
       .min = 0,
       .max = 1,
       .help = "acs: xi, how far a move draws its trail to that of the start.",
       .source = "Dorigo, Gambardella 1997, eq. (5)"},
  };
}

std::vector<Parameter> bounded_parameters() {
  return {
      {.name = "evaporation_decay",
       .default_value = 0.95,
       .min = 0,
       .max = 1,
       .help = "bounded: evaporation is multiplied by this every iteration.",
       .source = "Yin et al. 2021, eq. (10): public program for Li et al. 2019 [C]"},
      {.name = "evaporation_min",
       .default_value = 0.2,
       .min = 0,
       .max = 1,
       .help = "bounded: rho_min.",
       .source = "Yin et al. 2021, eq. (10): public program for Li et al. 2019 [C]"},
      {.name = "trail_min",
       .default_value = 10.0,
       .min = 0,
       .max = 1e9,
       .help = "bounded: tau_min.",
       .source = "Yin et al. 2021, eq. (11): public program for Li et al. 2019 [C]"},
      {.name = "trail_max",
       .default_value = 40.0,
       .min = 0,
       .max = 1e9,
       .help = "bounded: tau_max.",
       .source = "Yin et al. 2021, eq. (11): public program for Li et al. 2019 [C]"},
      {.name = "trail_bounds",
       .default_value = word("each-trail"),
       .choices = {"each-trail", "whole-matrix"},
       .help = "bounded: bounds act on each trail, as meant; or as coded, on all at once where all are beyond one.",
       .source = "whole-matrix: public program for Li et al. 2019 [C]"},
  };
}

std::vector<Parameter> factor_parameters() {
  return {
      {.name = "omega",
       .default_value = 10.0,
       .min = 0,
       .max = 1e6,
       .help = "Spread of the distance and smoothness factors.",
       .source = "Yin et al. 2021, eqs. (1), (3): public program for Li et al. 2019 [C]"},
      {.name = "mu0",
       .default_value = 1.0,
       .min = 0,
       .max = 1e6,
       .help = "Least value of the distance and smoothness factors.",
       .source = "Yin et al. 2021, eqs. (1), (3): public program for Li et al. 2019 [C]"},
      {.name = "u",
       .default_value = 10.0,
       .min = 0,
       .max = 1e6,
       .help = "Size of the safety factor.",
       .source = "Yin et al. 2021, eq. (2): public program for Li et al. 2019 [C]"},
      {.name = "theta",
       .default_value = 0.5,
       .min = 0,
       .max = 1,
       .help = "Weight of going straight on in the safety factor.",
       .source = "Yin et al. 2021, eq. (2): public program for Li et al. 2019 [C], theta reconstructed [R]"},
      {.name = "first_move",
       .default_value = word("shared"),
       .choices = {"shared", "straight"},
       .help = "Safety of the first move: u / n_i as coded, or that of a straight one.",
       .source = "shared: public program for Li et al. 2019 [C]"},
      {.name = "smoothness_range",
       .default_value = word("signed"),
       .choices = {"signed", "absolute"},
       .help = "Height differences that make the range under the smoothness factor.",
       .source = "Yin et al. 2021, eq. (3); signed: public program for Li et al. 2019 [C]"},
  };
}

/// How the factors make the weight of a move.
std::vector<Parameter> joining_parameters() {
  return {
      {.name = "join",
       .default_value = word("sum"),
       .choices = {"sum", "product"},
       .help = "How the factors make eta.",
       .source = "Yin et al. 2021, eq. (12); sum: public program for Li et al. 2019 [C]"},
      {.name = "step_factor",
       .default_value = true,
       .help = "Is 1 / d(i,j) one of the factors?",
       .source = "Yin et al. 2021, eq. (12): public program for Li et al. 2019 [C]"},
      {.name = "mu_power",
       .default_value = whole(0),
       .min = 0,
       .max = 16,
       .help = "Power of the adaptive factor mu; 0: left out, as in Li et al. 2019.",
       .source = "Yin et al. 2021, eq. (6), reconstructed [R]"},
      {.name = "mu_place",
       .default_value = word("beside"),
       .choices = {"beside", "inside"},
       .help = "mu stands beside eta^beta, or inside the power.",
       .source = "Yin et al. 2021, eq. (6), reconstructed [R]"},
      {.name = "mu_start",
       .default_value = 1.0,
       .min = 0,
       .max = 1e6,
       .help = "a, weight of the distance to the start in mu.",
       .source = "Yin et al. 2021, eq. (5), reconstructed [R]; a : b is unknown"},
      {.name = "mu_goal",
       .default_value = 1.0,
       .min = 0,
       .max = 1e6,
       .help = "b, weight of the distance to the goal in mu.",
       .source = "Yin et al. 2021, eq. (5), reconstructed [R]; a : b is unknown"},
  };
}

}  // namespace

std::vector<Parameter> grid_aco_parameters() {
  std::vector<Parameter> all;
  for (const auto& part : {walk_parameters(), score_parameters(), trail_parameters(), bounded_parameters(),
                           factor_parameters(), joining_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace alate
