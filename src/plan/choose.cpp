// Which planner runs: option beats scenario beats automatic choice.
#include <fmt/core.h>

#include "alate/plan/registry.hpp"

namespace alate {

namespace {

/// Place of a field in the scenario's text; the file alone where it is not there.
Fault scenario_fault(const Scenario& scenario, const std::string& field) {
  Fault fault{.file = scenario.file, .field = field};
  if (const auto mark = scenario.marks.find(field); mark != scenario.marks.end()) {
    fault.file = mark->second.file;
    fault.line = mark->second.line;
    fault.column = mark->second.column;
  }
  return fault;
}

std::vector<std::string> names_of(const std::vector<Preset>& presets) {
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.push_back(preset.name);
  return names;
}

struct Choice {
  const PlannerEntry* entry = nullptr;
  std::string chosen_by;
  std::string why;
};

std::string reason_for(const PlannerEntry& entry, const Site& site) {
  if (!entry.fits.empty()) return fmt::format("no planner was named; {}, so {} is taken", entry.fits, entry.name);
  return fmt::format("no planner was named; {}, on the {}, is the first that can serve this scenario", entry.name,
                     entry.can_on(site).space);
}

/// The first planner of the registry that serves the problem.
Choice choose_automatically(const Registry& registry, const Problem& problem) {
  std::vector<Fault> faults;
  for (const PlannerEntry& entry : registry.entries()) {
    std::string refusal = entry.refuses(problem);
    if (refusal.empty()) return {&entry, "auto", reason_for(entry, problem.world.site())};
    Fault fault = scenario_fault(problem.world.site().scenario, "vehicle");
    fault.message = fmt::format("{} cannot plan this: it {}", entry.name, refusal);
    faults.push_back(std::move(fault));
  }
  throw InputError(std::move(faults));
}

Choice choose_named(const Registry& registry, const Problem& problem, const PlannerRequest& request) {
  const Scenario& scenario = problem.world.site().scenario;
  const bool by_option = !request.name.empty();
  const std::string name = by_option ? request.name : scenario.planner->name;
  const PlannerEntry* entry = registry.find(name);
  if (entry == nullptr) {
    Fault where = by_option ? Fault{.file = "--planner"} : scenario_fault(scenario, "planner.name");
    throw InputError(unknown_name(std::move(where), "planner", name, registry.names()));
  }
  if (std::string refusal = entry->refuses(problem); !refusal.empty()) {
    Fault fault = scenario_fault(scenario, "vehicle");
    fault.message = fmt::format("{} cannot plan this: it {}", name, refusal);
    throw InputError(std::move(fault));
  }
  return {entry, by_option ? "option" : "scenario",
          by_option ? fmt::format("--planner asks for {}", name) : fmt::format("the scenario asks for {}", name)};
}

/// Preset and parameters of the scenario hold only for the planner that it names, or for any if it names none.
const PlannerSpec* spec_for(const PlannerEntry& entry, const Scenario& scenario) {
  if (!scenario.planner || (!scenario.planner->name.empty() && scenario.planner->name != entry.name)) return nullptr;
  return &*scenario.planner;
}

const Preset& choose_preset(const PlannerEntry& entry, const Scenario& scenario, const std::string& asked,
                            std::vector<Fault>& faults) {
  const PlannerSpec* spec = spec_for(entry, scenario);
  const bool by_option = !asked.empty();
  const std::string name = by_option ? asked : spec != nullptr ? spec->preset : "";
  if (name.empty()) return entry.presets.front();
  if (const Preset* preset = entry.find_preset(name)) return *preset;
  Fault where = by_option ? Fault{.file = "--preset"} : scenario_fault(scenario, "planner.preset");
  faults.push_back(unknown_name(std::move(where), "preset of " + entry.name, name, names_of(entry.presets)));
  return entry.presets.front();
}

std::vector<ParamSetting> all_settings(const PlannerEntry& entry, const Scenario& scenario,
                                       const std::vector<ParamSetting>& options) {
  std::vector<ParamSetting> settings;
  if (const PlannerSpec* spec = spec_for(entry, scenario)) {
    for (const auto& [name, text] : spec->parameters) {
      const Fault where = scenario_fault(scenario, "planner.parameters." + name);
      settings.push_back({.name = name, .text = text, .file = where.file, .line = where.line, .column = where.column});
    }
  }
  settings.insert(settings.end(), options.begin(), options.end());
  return settings;
}

}  // namespace

ChosenPlanner choose_planner(const Registry& registry, const Problem& problem, const PlannerRequest& request) {
  const Scenario& scenario = problem.world.site().scenario;
  const bool named = !request.name.empty() || (scenario.planner && !scenario.planner->name.empty());
  const Choice choice = named ? choose_named(registry, problem, request) : choose_automatically(registry, problem);
  std::vector<Fault> faults;
  const Preset& preset = choose_preset(*choice.entry, scenario, request.preset, faults);
  ParamValues values =
      choice.entry->parameters.resolve(preset.values, all_settings(*choice.entry, scenario, request.settings), faults);
  throw_if_any(std::move(faults));
  Planner planner = choice.entry->make(values);
  return {.name = choice.entry->name,
          .preset = preset.name,
          .chosen_by = choice.chosen_by,
          .why = choice.why,
          .parameters = std::move(values),
          .planner = std::move(planner)};
}

}  // namespace alate
