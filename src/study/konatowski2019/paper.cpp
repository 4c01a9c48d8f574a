#include "study/konatowski2019/paper.hpp"

#include <fmt/core.h>

#include "alate/data/scenario_file.hpp"

namespace alate::konatowski2019 {

namespace {

/// Start, target, step and angles of the paper. The goal's tolerance is ours: one step.
std::string scenario_text(const std::string& threats) {
  return fmt::format(R"(frame: {{local: true}}
start: {{position_m: [7, 1, 5], heading_deg: 90}}
goal: {{position_m: [20, 20, 10], tolerance_m: 2}}
vehicle:
  step_m: 2
  roll_deg: [-15, -7.5, 0, 7.5, 15]
  pitch_deg: [-15, -7.5, 0, 7.5, 15]
  yaw_deg: [-15, -7.5, 0, 7.5, 15]
threats:{}
objective: {{model: konatowski2019, fuel: 0.5, threat: 0.5}}
)",
                     threats);
}

const std::string kThreatsA = R"(
  - {name: A1, center_m: [13.5, 10.5, 7.5], radius_m: 5, level: 0.5})";
const std::string kThreatsC = R"(
  - {name: C1, center_m: [11, 8, 6.5], radius_m: 4, level: 0.5}
  - {name: C2, center_m: [15, 12, 8], radius_m: 4, level: 0.5}
  - {name: C3, center_m: [17.5, 17, 9], radius_m: 3, level: 0.5})";
const std::string kThreatsF = R"(
  - {name: F1, center_m: [16.9, 13.6, 5.2], radius_m: 8, level: 0.5}
  - {name: F2, center_m: [16.1, 12.6, 4.9], radius_m: 8, level: 0.5}
  - {name: F3, center_m: [16.5, 14, 5.2], radius_m: 8, level: 0.5})";

struct Asked {
  const char* name = "";
  const char* planner = "";
  const char* preset = "";  ///< Empty: the planner's default.
  const char* parameter = nullptr;
  const char* value = nullptr;
  const char* help = "";
};

StudyMethod method(const Asked& asked, std::optional<std::uint64_t> iterations) {
  const auto setting = [](const char* name, std::string text) {
    return ParamSetting{.name = name, .text = std::move(text), .file = "reproduce"};
  };
  std::vector<ParamSetting> settings{setting("step_limit", std::to_string(kStepLimit))};
  if (asked.parameter != nullptr) settings.push_back(setting(asked.parameter, asked.value));
  return {.name = asked.name,
          .help = asked.help,
          .request = {.name = asked.planner, .preset = asked.preset, .settings = std::move(settings)},
          .iterations = iterations};
}

}  // namespace

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> all{
      {.name = "A", .scenario = scenario_text(kThreatsA), .best_known = {29.28, 69.15, 107.60}},
      {.name = "C", .scenario = scenario_text(kThreatsC), .best_known = {28.72, 69.71, 108.03}},
      {.name = "F", .scenario = scenario_text(kThreatsF), .best_known = {30.61, 75.37, 112.17}}};
  return all;
}

const Layout& open_layout() {
  static const Layout open{.name = "open", .scenario = scenario_text(" []")};
  return open;
}

std::string case_name(const Layout& layout, const Published& row) {
  return fmt::format("{}-{:.1f}", layout.name, row.fuel);
}

StudyCase make_case(const Layout& layout, const Published& row) {
  const std::vector<std::string> weights{fmt::format("objective.fuel={}", row.fuel),
                                         fmt::format("objective.threat={}", row.threat)};
  return {.name = case_name(layout, row),
          .world = World(load_site(parse_scenario(layout.scenario, "layout " + layout.name, weights)))};
}

std::vector<StudyMethod> methods(const std::optional<std::uint64_t>& iterations) {
  constexpr const char* kAnts = "attitude-aco";
  constexpr const char* kAsPrinted = "the paper's rule as printed";
  const std::uint64_t published = iterations.value_or(kIterations);
  return {
      method({kLiteral20, kAnts, "konatowski2019", "ants", "20", kAsPrinted}, published),
      method({kLiteral, kAnts, "konatowski2019", "ants", "50", kAsPrinted}, published),
      method({kLiteral100, kAnts, "konatowski2019", "ants", "100", kAsPrinted}, published),
      method(
          {kRank, kAnts, "konatowski2019-rank", "ants", "50", "the paper's rule, only the best ants leave pheromone"},
          published),
      method({kMaxMin, kAnts, "konatowski2019-mmas", "ants", "50", "the paper's rule, pheromone between two limits"},
             published),
      method({kNoPheromone, kAnts, "no-pheromone", "ants", "50", "the paper's walks without any memory"}, published),
      method({kGreedyJ, "greedy", "", "score", "J", "one walk, always to the cheapest next node"}, {}),
      method({kGreedyJh, "greedy", "", "score", "J+h", "one walk by the next node and a bound of the rest"}, {}),
      method({kBeam, "beam", "", nullptr, nullptr, "keeps the best few states of every step"}, {}),
      method({kAcs, kAnts, "acs", nullptr, nullptr, "Ant Colony System on trail cells, directed to the goal"},
             iterations),
      method({kGuided, kAnts, "guided", nullptr, nullptr, "alate's own: directed to the goal, MAX-MIN, local search"},
             iterations),
  };
}

}  // namespace alate::konatowski2019
