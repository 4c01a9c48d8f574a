#include "study/yin2021/paper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace alate::yin2021 {

namespace {

using Settings = std::vector<Setting>;

Reading both(const char* name, const char* help, Settings settings) {
  return {.name = name, .help = help, .li = settings, .yin = std::move(settings)};
}

Reading mu(const char* name, const char* help, Settings settings) {
  return {.name = name, .help = help, .li = {}, .yin = std::move(settings)};
}

ParamSetting setting(const char* name, const char* value) { return {.name = name, .text = value, .file = "reproduce"}; }

/// The presets but for the diagonal: the paper says "Euclidean".
StudyMethod method(std::string name, const char* preset, const Settings& settings,
                   const std::optional<std::uint64_t>& iterations) {
  StudyMethod method{.name = std::move(name),
                     .help = "",
                     .request = {.name = "grid-aco", .preset = preset, .settings = {setting("diagonal", "sqrt2")}},
                     .iterations = iterations.value_or(kIterations)};
  for (const Setting& each : settings) method.request.settings.push_back(setting(each.name, each.value));
  return method;
}

StudyMethod with_help(StudyMethod method, const char* help) {
  method.help = help;
  return method;
}

}  // namespace

std::string size_name(Size size) { return fmt::format("{0}x{0}", kSizes[size]); }

const std::vector<Reading>& readings() {
  static const std::vector<Reading> all{
      {.name = kAsMeant,
       .help =
           "F over the cells of the route, bounds on each trail, diagonals cost sqrt(2), eta a sum, mu to the power "
           "1 with a : b = 1 : 1, deposit Q/S",
       .li = {},
       .yin = {}},
      both(kAsCoded, "the next two together, and diagonals cost 1.4: the public program",
           {{"heights_of", "matrix"}, {"trail_bounds", "whole-matrix"}, {"diagonal", "1.4"}}),
      both(kHeightsAsCoded, "F over the first cells of the height matrix", {{"heights_of", "matrix"}}),
      both(kBoundsAsCoded, "bounds act on all trails at once", {{"trail_bounds", "whole-matrix"}}),
      both(kNoBounds, "bounds on all trails at once, too wide ever to act",
           {{"trail_bounds", "whole-matrix"}, {"trail_min", "0"}, {"trail_max", "1e9"}}),
      both("diagonal 1.4", "diagonals cost 1.4", {{"diagonal", "1.4"}}),
      both("eta a product", "the factors of eq. (12) are multiplied", {{"join", "product"}}),
      both("deposit Q/L", "ants leave Q over the length", {{"deposit_over", "length"}}),
      both("absolute range", "absolute height differences below the line of eq. (3) too",
           {{"smoothness_range", "absolute"}}),
      both("length alone", "ants are ranked by L, not by S", {{"weight_height", "0"}, {"weight_turns", "0"}}),
      {.name = kStepFactor,
       .help = "1/d(i,j) is new in Yin et al., not of the baseline",
       .li = {{"step_factor", "false"}},
       .yin = {}},
      mu("a : b = 1 : 9", "the goal weighs more in mu", {{"mu_start", "0.1"}, {"mu_goal", "0.9"}}),
      mu("a : b = 9 : 1", "the start weighs more in mu", {{"mu_start", "0.9"}, {"mu_goal", "0.1"}}),
      mu("mu to the power 2", "mu squared", {{"mu_power", "2"}}),
      mu("mu inside the power", "(eta mu)^beta, which is mu to the power 3", {{"mu_place", "inside"}}),
      mu("mu to the power 8", "far beyond any reading of the paper", {{"mu_power", "8"}}),
  };
  return all;
}

std::size_t reading_index(std::string_view name) {
  const auto found = std::ranges::find(readings(), name, &Reading::name);
  assert(found != readings().end());
  return static_cast<std::size_t>(found - readings().begin());
}

std::string method_name(const char* method, const Reading& reading) {
  return fmt::format("{}, {}", method, reading.name);
}

std::vector<StudyMethod> main_methods(const std::optional<std::uint64_t>& iterations) {
  StudyMethod greedy = method(kGreedy, "",
                              {{"heuristic", "goal-distance"},
                               {"alpha", "0"},
                               {"q0", "1"},
                               {"ants", "1"},
                               {"follow", "0"},
                               {"give_up", "0"},
                               {"local_search", "none"}},
                              {});
  greedy.iterations = 1;
  return {
      with_help(method(kLi, "li2019", {}, iterations), "the baseline, mu left out"),
      with_help(method(kYin, "yin2021", {}, iterations), "the paper's, with mu"),
      with_help(method(kNoPheromone, "li2019", {{"alpha", "0"}}, iterations), "the baseline's walks without memory"),
      with_help(method(kImproved, "improved", {{"ants", "50"}}, iterations), "alate's own colony, for length"),
      with_help(std::move(greedy), "one walk, always to the free cell nearest to the goal"),
  };
}

std::vector<StudyMethod> reading_methods(const std::optional<std::uint64_t>& iterations) {
  const Reading& meant = readings().front();
  std::vector<StudyMethod> all{method(method_name(kLi, meant), "li2019", meant.li, iterations),
                               method(method_name(kYin, meant), "yin2021", meant.yin, iterations)};
  for (const Reading& reading : readings()) {
    if (!reading.li.empty()) all.push_back(method(method_name(kLi, reading), "li2019", reading.li, iterations));
    if (!reading.yin.empty()) all.push_back(method(method_name(kYin, reading), "yin2021", reading.yin, iterations));
  }
  for (StudyMethod& each : all) each.keep_routes = each.name.ends_with(kHeightsAsCoded);  // Their cells are counted.
  return all;
}

std::string scenario_text(Size size, int seed) {
  const int side = kSizes[size];
  return fmt::format(
      "grid:\n"
      "  random: {{size: [{0}, {0}], obstacles: 0.2, seed: {1}}}\n"
      "  heights: peaks\n"
      "start: {{cell: [0, {2}]}}\n"
      "goal: {{cell: [{2}, 0]}}\n",
      side, seed, side - 1);
}

// NOLINTBEGIN(bugprone-suspicious-missing-comma): each note is broken over lines.
std::vector<std::string> notes() {
  return {
      "The paper's maps, its Tables 1 to 3 and its a and b were not available. Its numbers cannot be reproduced; its "
      "claims are tested on other maps, and hold or fail there.",
      "Eqs. (5) and (6), the new factor mu, are reconstructed from the paper's prose. Eqs. (1) to (4) and (7) to (12) "
      "are those of a public program for its baseline, Li et al. 2019.",
      "Both methods get the same parameters (the baseline's), the same seeds and the same budget. They differ by mu "
      "alone, and in one reading, named so, by 1/d(i,j).",
      "There are many maps of each size, not one, with 95 % confidence intervals over the maps: on one map 30 runs let "
      "the ratio of the variances swing by itself.",
      "The public program takes the height deviation F over wrong cells, and its bounds on pheromone act only "
      "where all trails at once are beyond one. The main results are for both as meant; both as coded stand beside.",
      "The paper compares with one baseline only and states no test of significance. Here a walk without pheromone, a "
      "greedy walk, another colony and the exact shortest way stand beside.",
  };
}
// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace alate::yin2021
