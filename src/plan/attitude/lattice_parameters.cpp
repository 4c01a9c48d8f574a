#include "plan/attitude/lattice_parameters.hpp"

#include "plan/parameter_values.hpp"

namespace alate {

namespace {

std::vector<Parameter> step_parameters() {
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

/// A limit of 0 is none.
double limit(double value) { return value > 0 ? value : kInfinity; }

MainDirection main_direction(std::string_view word) {
  if (word == "x") return MainDirection::x;
  if (word == "y") return MainDirection::y;
  return word == "line" ? MainDirection::line : MainDirection::automatic;
}

LatticeSteps steps_of(const ParamValues& values) {
  const MainDirection main = main_direction(values.text("main_direction"));
  return {.main = main,
          .main_m = values.number("step_m"),
          .side_m = values.number("side_m"),
          .side_share = main == MainDirection::line ? 0.5 : 1,
          .height_m = values.number("height_m"),
          .window_side = static_cast<int>(values.integer("window_side")),
          .window_height = static_cast<int>(values.integer("window_height"))};
}

/// False for a parameter that the planner does not have.
bool is_set(const ParamValues& values, std::string_view name, std::string_view to) {
  return values.all().contains(name) && values.text(name) == to;
}

LatticeRules rules_of(const ParamValues& values) {
  return {.limits = {.length_m = limit(values.number("length_max_m")),
                     .leg_m = values.number("leg_min_m"),
                     .height_agl_m = values.number("height_min_agl_m"),
                     .height_amsl_m = limit(values.number("height_max_m")),
                     .pitch_rad = radians(values.number("pitch_max_deg")),
                     .turn_rad = radians(values.number("turn_max_deg"))},
          .filters = !is_set(values, "constraints", "penalty"),
          .safe_agl_m = values.number("safe_height_m"),
          .whole_legs = !is_set(values, "safety", "node"),
          .any_join = values.text("join") == "any",
          .prunes = !is_set(values, "dead_ends", "kept")};
}

TerrainScore score_of(const ParamValues& values) {
  TerrainScore score{.penalty = is_set(values, "constraints", "penalty") ? values.number("penalty") : 0};
  if (!is_set(values, "fitness", "paper")) return score;
  score.rule = TerrainScore::Rule::paper;
  score.length = values.number("weight_length");
  score.height = values.number("weight_height");
  score.turn = values.number("weight_turn");
  score.datum = is_set(values, "height_above", "ground") ? TerrainScore::Datum::ground : TerrainScore::Datum::sea;
  score.degrees = is_set(values, "angle_unit", "deg");
  return score;
}

}  // namespace

std::vector<Parameter> lattice_parameters() {
  std::vector<Parameter> all;
  for (const auto& part : {step_parameters(), leg_parameters(), constraint_parameters(), score_parameters()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

LatticeOptions lattice_options(const ParamValues& values) {
  return {.steps = steps_of(values), .rules = rules_of(values), .score = score_of(values)};
}

}  // namespace alate
