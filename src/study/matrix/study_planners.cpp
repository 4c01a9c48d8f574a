// Planners of a study, with presets and parameters.
#include <fmt/core.h>

#include <algorithm>

#include "data/limits.hpp"
#include "study/matrix/ranges.hpp"
#include "study/matrix/study_parts.hpp"

namespace alate {

namespace {

std::vector<std::string> names_of(const std::vector<Preset>& presets) {
  std::vector<std::string> names;
  for (const Preset& preset : presets) names.push_back(preset.name);
  return names;
}

class PlannerList {
 public:
  PlannerList(const Registry& registry, StudyFaults& faults) : registry_(registry), faults_(faults) {}

  void read(const Node& item, const std::string& field) {
    if (item.kind == Node::Kind::broken) return;
    if (item.kind != Node::Kind::map)
      return faults_.report(item.place, {.field = field, .value = item.text, .message = "must be a group of keys"});
    faults_.check_keys(item, field, {"name", "preset", "parameters"});
    if (expanded_count(item, kMaxStudyPlanners) == 0)
      return faults_.report(item.place, {.field = field,
                                         .limit = fmt::format("{}", kMaxStudyPlanners),
                                         .unit = "planners",
                                         .message = "has a range that runs backwards or is too long"});
    const std::size_t before = faults_.all().size();
    for (const Expanded& each : expand(item)) {
      read_one(each.node, field);
      if (faults_.all().size() != before) return;  // The others would fail in the same way.
    }
  }

  std::vector<PlannerItem> take() { return std::move(items_); }

 private:
  void read_one(const Node& item, const std::string& field) {
    const Node* name = item.find("name");
    if (name == nullptr) return faults_.report(item.place, {.field = field + ".name", .message = "is missing"});
    if (!faults_.is_word(*name, field + ".name")) return;
    const PlannerEntry* entry = registry_.find(name->text);
    if (entry == nullptr)
      return faults_.report(name->place,
                            unknown_name({.field = field + ".name"}, "planner", name->text, registry_.names()));
    const Preset* preset = read_preset(item, *entry, field);
    std::string shown;
    const std::vector<ParamSetting> settings = read_settings(item, field, shown);
    std::vector<Fault> found;
    const ParamValues values = entry->parameters.resolve(preset->values, settings, found);
    faults_.take(std::move(found), "");
    PlannerItem made{.planner = {.name = entry->name,
                                 .preset = preset->name + shown,
                                 .can_on = [entry](const Site& site) { return entry->can_on(site); },
                                 .chance = !entry->can.deterministic,
                                 .planner = entry->make(values)},
                     .entry = entry,
                     .place = name->place,
                     .field = field};
    const std::string label = label_of(made.planner);
    if (std::ranges::any_of(items_, [&](const PlannerItem& each) { return label_of(each.planner) == label; }))
      return faults_.report(name->place, {.field = field, .value = label, .message = "given twice"});
    items_.push_back(std::move(made));
  }

  const Preset* read_preset(const Node& item, const PlannerEntry& entry, const std::string& field) {
    const Preset* fallback = &entry.presets.front();
    const Node* node = item.find("preset");
    if (node == nullptr || !faults_.is_word(*node, field + ".preset")) return fallback;
    if (const Preset* preset = entry.find_preset(node->text)) return preset;
    faults_.report(node->place, unknown_name({.field = field + ".preset"}, "preset of " + entry.name, node->text,
                                             names_of(entry.presets)));
    return fallback;
  }

  std::vector<ParamSetting> read_settings(const Node& item, const std::string& field, std::string& shown) {
    std::vector<ParamSetting> settings;
    const Node* node = item.find("parameters");
    if (node == nullptr || node->kind == Node::Kind::broken) return settings;
    if (node->kind != Node::Kind::map) {
      faults_.report(node->key_place, {.field = field + ".parameters", .message = "must be a group of keys"});
      return settings;
    }
    for (const Node& child : node->children) {
      if (!faults_.is_word(child, field + ".parameters." + child.key)) continue;
      settings.push_back({.name = child.key,
                          .text = child.text,
                          .file = faults_.file(),
                          .line = child.place.line,
                          .column = child.place.column});
      shown += fmt::format(" {}={}", child.key, child.text);
    }
    return settings;
  }

  const Registry& registry_;
  StudyFaults& faults_;
  std::vector<PlannerItem> items_;
};

}  // namespace

std::string label_of(const StudyPlanner& planner) { return planner.name + " " + planner.preset; }

std::vector<PlannerItem> read_study_planners(const Node& list, const Registry& registry, StudyFaults& faults) {
  PlannerList planners(registry, faults);
  for (std::size_t i = 0; i < list.children.size(); ++i) planners.read(list.children[i], fmt::format("planners.{}", i));
  std::vector<PlannerItem> items = planners.take();
  if (items.size() > kMaxStudyPlanners)
    faults.report(list.place, {.field = "planners",
                               .value = fmt::format("{}", items.size()),
                               .limit = fmt::format("{}", kMaxStudyPlanners),
                               .message = "too many planners"});
  return items;
}

}  // namespace alate
