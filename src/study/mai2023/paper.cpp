#include "study/mai2023/paper.hpp"

#include <fmt/core.h>

namespace alate::mai2023 {

namespace {

/// Kilometres.
struct Peak {
  std::array<double, 2> center;
  double height;
  std::array<double, 2> slope;
};

/// Tables 1 to 3; of table 3 only the first four rows are known, the others are ours.
const std::vector<Peak>& peaks_of(Scene scene) {
  static const std::array<std::vector<Peak>, kScenes.size()> peaks{{
      {{{30, 9}, 0.66, {4, 3}}, {{16, 17}, 1.64, {7, 8}}, {{35, 32}, 1.3, {5, 8}}},
      {{{40, 10}, 1.8, {4, 3}},
       {{12, 17}, 0.66, {2, 1}},
       {{21, 25}, 1.86, {4, 4}},
       {{33, 34}, 1.64, {7, 8}},
       {{10, 41}, 0.3, {5, 8}},
       {{14, 32}, 0.96, {12, 8}},
       {{6, 26}, 1.3, {6, 5}},
       {{33, 15}, 2.3, {4, 12}}},
      {{{40, 10}, 1.08, {4, 3}},
       {{35, 45}, 0.66, {2, 2}},
       {{36, 25}, 1.86, {3, 5}},
       {{15, 40}, 1.64, {2, 3}},
       {{25, 24}, 2.4, {3, 6}},
       {{12, 12}, 1.9, {3, 5}},
       {{22, 9}, 1.5, {4, 3}},
       {{8, 27}, 1.7, {5, 3}},
       {{44, 38}, 2.1, {4, 3}},
       {{27, 38}, 2.2, {6, 3}},
       {{46, 22}, 1.2, {3, 3}},
       {{20, 30}, 1.4, {3, 3}}},
  }};
  return peaks[scene];
}

struct Asked {
  const char* name = "";
  const char* preset = "";
  std::vector<Setting> settings;
  const char* help = "";
};

StudyMethod method(const Asked& asked, const std::optional<std::uint64_t>& iterations) {
  StudyMethod method{.name = asked.name,
                     .help = asked.help,
                     .request = {.name = "terrain-aco", .preset = asked.preset, .settings = {}},
                     .iterations = iterations.value_or(kIterations)};
  for (const Setting& each : asked.settings)
    method.request.settings.push_back({.name = each.name, .text = each.value, .file = "reproduce"});
  return method;
}

std::vector<Setting> operator+(std::vector<Setting> first, const std::vector<Setting>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The lattice and the score of the paper's preset.
const std::vector<Setting> kPapersScore{
    {"fitness", "paper"},     {"main_direction", "auto"}, {"polish", "none"},     {"join", "any"},
    {"safe_height_m", "100"}, {"pitch_max_deg", "45"},    {"turn_max_deg", "60"}, {"ants", "30"}};

}  // namespace

std::string scenario_text(Scene scene, const std::string& combine) {
  constexpr double kKm = 1000;
  std::string peaks;
  for (const Peak& peak : peaks_of(scene))
    peaks += fmt::format("    - {{center_m: [{:.0f}, {:.0f}], height_m: {:.0f}, slope_m: [{:.0f}, {:.0f}]}}\n",
                         kKm * peak.center[0], kKm * peak.center[1], kKm * peak.height, kKm * peak.slope[0],
                         kKm * peak.slope[1]);
  return fmt::format(
      "frame: {{local: true}}\n"
      "terrain:\n"
      "  peaks:\n{}"
      "  combine: {}\n"
      "  extent_m: [50000, 50000]\n"
      "  clearance_m: 100\n"
      "  ceiling_amsl_m: 3000\n"
      "start: {{position_m: [0, 0, 1000]}}\n"
      "goal: {{position_m: [50000, 50000, 1000]}}\n",
      peaks, combine);
}

const std::vector<Reading>& readings() {
  static const std::vector<Reading> all{
      {.name = kAsChosen,
       .help = "trails on edges, evaporation on the updated path alone, S M D for both, peaks added"},
      {.name = "trails on nodes", .help = "as in the teaching example", .both = {{"trail_on", "nodes"}}},
      {.name = "all trails evaporate", .help = "eq. (16) for all", .mai = {{"evaporation_scope", "global"}}},
      {.name = "baseline with 1/d", .help = "eta = 1/d, not S M D", .aco = {{"heuristic", "goal-distance"}}},
      {.name = "highest peak", .help = "eq. (1) takes the maximum of the peaks, not their sum", .combine = kMax},
      {.name = "each ant updates", .help = "fit_current is each ant's", .mai = {{"fitness_current", "each-ant"}}},
      {.name = "factors in cells", .help = "eqs. (12), (13) count cells", .both = {{"factor_unit", "cells"}}},
      {.name = "nodes clear", .help = "S asks of nodes, not of legs", .both = {{"safety", "node"}}},
      {.name = "heights above ground", .help = "h_i of eq. (22)", .both = {{"height_above", "ground"}}},
      {.name = "angles in degrees", .help = "theta_i of eq. (23)", .both = {{"angle_unit", "deg"}}},
      {.name = "length alone", .help = "w2 = w3 = 0", .both = {{"weight_height", "0"}, {"weight_turn", "0"}}},
      {.name = "window 1", .help = "one cell a move", .both = {{"window_side", "1"}, {"window_height", "1"}}},
      {.name = "penalties", .help = "constraints add to F", .both = {{"constraints", "penalty"}}},
      {.name = "no dead ends", .help = "pruned beforehand", .both = {{"dead_ends", "pruned"}}},
      {.name = kLittlePheromone, .help = "a tenth of the pheromone", .both = {{"q", "10"}}},
      {.name = "baseline deposits Q/F", .help = "not Q/L", .aco = {{"deposit_over", "fitness"}}},
  };
  return all;
}

std::vector<StudyMethod> main_methods(const std::optional<std::uint64_t>& iterations) {
  const std::vector<Setting> strategy_1{{"q0", "0.9"}, {"q0_schedule", "paper"}};
  const std::vector<Setting> strategy_2{{"deposit", "dual"}, {"evaporation_scope", "path"}};
  const std::vector<Setting> one_walk{{"alpha", "0"}, {"q0", "1"}, {"ants", "1"}, {"dead_ends", "pruned"}};
  return {
      method({kAco, "aco", {}, "the baseline"}, iterations),
      method({kMai, "mai2023", {}, "the paper's: both strategies"}, iterations),
      method({kSelection, "aco", strategy_1, "deterministic selection alone, eqs. (14), (15)"}, iterations),
      method({kUpdate, "aco", strategy_2, "pheromone update alone, eqs. (16) to (19)"}, iterations),
      method({kMaiBlind, "mai2023", {{"alpha", "0"}}, "its walks without memory"}, iterations),
      method({kAcoBlind, "aco", {{"alpha", "0"}}, "the baseline's walks without memory"}, iterations),
      method({kNearest, "aco", {{"heuristic", "goal-distance"}}, "the baseline with the textbook's heuristic"},
             iterations),
      method({kImprovedF, "improved", kPapersScore, "alate's own colony, looking for a low F"}, iterations),
      method({kImproved, "improved", {{"ants", "30"}}, "alate's own colony, looking for short routes"}, iterations),
      method({kGreedy, "aco", one_walk, "one walk by S M D, always to the best node that is no dead end"}, 1),
  };
}

std::vector<StudyMethod> reading_methods(const Reading& reading, const std::optional<std::uint64_t>& iterations) {
  std::vector<StudyMethod> all{method({kAco, "aco", reading.both + reading.aco}, iterations),
                               method({kMai, "mai2023", reading.both + reading.mai}, iterations)};
  for (StudyMethod& each : all) each.keep_routes = false;
  return all;
}

// NOLINTBEGIN(bugprone-suspicious-missing-comma): each note is broken over lines.
std::vector<std::string> notes() {
  return {
      "No figure of any result and no parameter value of the paper were available to us. This is an implementation of "
      "its published update rules on its published simple and medium terrains, not a reproduction of its results; no "
      "percentage of improvement is known, so none is judged.",
      "Its complex terrain is cut off after the fourth peak and cannot be rebuilt. The third scene has these four and "
      "eight peaks of ours: it says something of the method, nothing of the paper's third scene.",
      "Eqs. (4) and (7) to (23) are as printed, but for (14), the choice by q0, which is the usual rule of Ant Colony "
      "System, as are the constraints (2), (3), (6) and the order of the steps; (5) was half readable. Eq. (1), the "
      "terrain, is taken for a sum of Gaussian peaks.",
      "Parameters are ours, the same for both methods: 500 iterations of 30 ants, alpha 1, beta 2, rho 0.2, Q 100, "
      "trails from 0.1 to 10, lambda 0.5, q0 0.9, all weights 1, a map of 50 x 50 km, steps of 1 x 1 x 0.2 km, windows "
      "of two cells. n counts from 0; lambda does not decay before the first iteration.",
      "Fitness is F of eq. (20), in km, km and radians; lower is better, and it is what both methods look for. The "
      "iteration number is that of the last change of the best route. Times are of our program, on one thread.",
      "Beside both methods stand: each strategy by itself, both without pheromone, one greedy walk, colonies of ours, "
      "and the exact least F of the lattice.",
  };
}
// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace alate::mai2023
