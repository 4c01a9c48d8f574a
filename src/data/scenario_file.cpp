#include "alate/data/scenario_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "data/limits.hpp"
#include "data/scenario_override.hpp"
#include "data/scenario_reader.hpp"
#include "data/scenario_rules.hpp"
#include "data/scenario_text.hpp"

namespace alate {

namespace {

void name_threats(std::vector<ThreatSpec>& threats) {
  for (std::size_t i = 0; i < threats.size(); ++i) {
    if (threats[i].name.empty()) threats[i].name = fmt::format("threat {}", i + 1);
  }
}

/// Beside navigation errors and on grids the cost is the length, unless the scenario says otherwise.
void default_climb(Scenario& scenario) {
  const bool physical = scenario.objective.model == CostModel::physical;
  if ((scenario.navigation || scenario.grid) && physical && !scenario.marks.contains("objective.climb"))
    scenario.objective.climb = 0;
}

/// In the order of the text, and no more than a person reads.
[[noreturn]] void throw_all(std::vector<Fault> faults) {
  std::ranges::stable_sort(faults, {}, [](const Fault& fault) { return std::tie(fault.line, fault.column); });
  if (faults.size() > kMaxFaults) {
    const std::size_t more = faults.size() - kMaxFaults;
    faults.resize(kMaxFaults);
    faults.push_back({.file = faults.back().file, .message = fmt::format("and {} more faults", more)});
  }
  throw InputError(std::move(faults));
}

Node read_tree(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
               std::vector<Fault>& faults) {
  check_scenario_text(text, file, faults);
  if (!faults.empty()) throw_all(std::move(faults));
  Node root = parse_document(text, file, faults);
  if (root.kind == Node::Kind::null) {
    faults.push_back({.file = file, .message = "the file is empty"});
  } else if (root.kind == Node::Kind::map) {
    for (const std::string& text_of_override : overrides) apply_override(text_of_override, root, faults);
  } else if (root.kind != Node::Kind::broken) {
    faults.push_back({.file = file, .message = "a scenario is a group of keys, such as start and goal"});
  }
  if (root.kind != Node::Kind::map) throw_all(std::move(faults));
  return root;
}

}  // namespace

Scenario scenario_of(const Node& root, const std::string& file, std::vector<Fault>& faults) {
  Scenario scenario;
  scenario.file = file;
  read_scenario(root, scenario, faults);
  name_threats(scenario.threats);
  default_climb(scenario);
  check_rules(scenario, faults);
  return scenario;
}

Scenario parse_scenario(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<Fault> faults;
  const Node root = read_tree(text, file, overrides, faults);
  Scenario scenario = scenario_of(root, file, faults);
  scenario.overrides = overrides;
  if (!faults.empty()) throw_all(std::move(faults));
  return scenario;
}

Scenario load_scenario(const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<Fault> faults;
  const std::string text = read_scenario_text(file, faults);
  throw_if_any(std::move(faults));
  return parse_scenario(text, file, overrides);
}

}  // namespace alate
