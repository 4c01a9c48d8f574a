// alate planners: what can plan, what each can do, and its parameters.
#include <fmt/core.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "alate/plan/registry.hpp"
#include "commands.hpp"

namespace alate::cli {

namespace {

using Json = nlohmann::ordered_json;

struct PlannersLine {
  Text name;
  bool json = false;
};

Json to_value(const ParamValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Json to_value(const PlannerEntry& entry) {
  Json parameters = Json::array();
  for (const Parameter& each : entry.parameters.parameters())
    parameters.push_back({{"name", each.name},
                          {"unit", each.unit},
                          {"default", to_value(each.default_value)},
                          {"range", each.range()},
                          {"help", each.help},
                          {"source", each.source}});
  Json presets = Json::array();
  for (const Preset& each : entry.presets) presets.push_back(each.name);
  const Abilities& can = entry.can;
  return {{"name", entry.name},
          {"help", entry.help},
          {"presets", presets},
          {"can",
           {{"exact", can.exact},
            {"anytime", can.anytime},
            {"deterministic", can.deterministic},
            {"terrain", can.terrain},
            {"threats", can.threats},
            {"voxels", can.voxels},
            {"space", can.space}}},
          {"parameters", parameters}};
}

std::string abilities(const Abilities& can) {
  std::string text = "on the " + can.space;
  const std::array<std::pair<bool, const char*>, 6> words{{{can.exact, "exact"},
                                                           {can.anytime, "anytime"},
                                                           {can.deterministic, "deterministic"},
                                                           {can.terrain, "rounds terrain"},
                                                           {can.threats, "avoids threats"},
                                                           {can.voxels, "flies among voxels as well"}}};
  for (const auto& [holds, word] : words)
    if (holds) text += fmt::format(", {}", word);
  return text;
}

std::string describe(const PlannerEntry& entry) {
  std::string text = fmt::format("{}: {}\n  {}\n", entry.name, entry.help, abilities(entry.can));
  for (const Preset& each : entry.presets) text += fmt::format("  preset {}: {}\n", each.name, each.help);
  for (const Parameter& each : entry.parameters.parameters()) {
    const std::string unit = each.unit.empty() ? "" : " " + each.unit;
    text += fmt::format("  {} = {}{} ({}{}): {} [{}]\n", each.name, to_text(each.default_value), unit, each.range(),
                        unit, each.help, each.source);
  }
  return text;
}

std::vector<PlannerEntry> asked_for(const Text& name, FaultList& faults) {
  const Registry& registry = builtin_planners();
  if (!name) return registry.entries();
  if (const PlannerEntry* entry = registry.find(*name)) return {*entry};
  faults.add(unknown_name({.file = "NAME"}, "planner", *name, registry.names()));
  return {};
}

int list_planners(const PlannersLine& line, FaultList faults) {
  const std::vector<PlannerEntry> entries = asked_for(line.name, faults);
  faults.throw_if_any();
  if (line.json) {
    Json all = Json::array();
    for (const PlannerEntry& each : entries) all.push_back(to_value(each));
    fmt::print("{}\n", all.dump(2));
    return kDone;
  }
  for (const PlannerEntry& each : entries) fmt::print("{}", describe(each));
  return kDone;
}

}  // namespace

void add_planners(CLI::App& app, Command& chosen) {
  const auto line = std::make_shared<PlannersLine>();
  CLI::App& command =
      *add_command(app, "planners", "List the planners, what each can do, and its parameters", "alate planners beam");
  add_text(command, "NAME", line->name, "only this planner");
  command.add_flag("--json", line->json, "as JSON on standard output, and nothing else");
  command.callback(
      [&chosen, line] { chosen = [line](FaultList faults) { return list_planners(*line, std::move(faults)); }; });
}

}  // namespace alate::cli
