// Reads a study and lays out its runs.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "alate/core/version.hpp"
#include "alate/data/scenario_file.hpp"
#include "alate/study/study.hpp"
#include "data/limits.hpp"
#include "data/scenario_text.hpp"
#include "study/matrix/checksum.hpp"
#include "study/matrix/study_parts.hpp"

namespace alate {

namespace {

Node read_root(const std::string& file, std::string& text, StudyFaults& faults) {
  text = read_scenario_text(file, faults.all());
  faults.throw_if_any();
  check_scenario_text(text, file, faults.all());
  faults.throw_if_any();
  Node root = parse_document(text, file, faults.all());
  if (root.kind == Node::Kind::map) return root;
  if (root.kind != Node::Kind::broken)
    faults.report(root.place, {.message = "a study is a group of keys: scenarios, planners, seeds, budgets"});
  faults.throw_if_any();
  return root;
}

/// What a planner says to the scenarios of one group.
struct Answers {
  std::size_t asked = 0;
  std::size_t refused = 0;
  std::string scenario;  ///< The first refused.
  std::string why;
};

Answers answers_of(const PlannerItem& item, const std::vector<StudyScenario>& scenarios, std::size_t group) {
  Answers answers;
  for (const StudyScenario& scenario : scenarios) {
    if (scenario.group != group) continue;
    ++answers.asked;
    std::string refusal = item.entry->refuses(Problem(scenario.world));
    if (refusal.empty() || ++answers.refused > 1) continue;
    answers.scenario = scenario.name;
    answers.why = std::move(refusal);
  }
  return answers;
}

/// A planner must serve all scenarios of a group or none, and one group at least.
void note_refusals(const std::vector<PlannerItem>& planners, Study& study, StudyFaults& faults) {
  for (std::size_t p = 0; p < planners.size(); ++p) {
    const PlannerItem& item = planners[p];
    std::size_t refused = 0;
    for (std::size_t group = 0; group < study.groups.size(); ++group) {
      const Answers answers = answers_of(item, study.scenarios, group);
      if (answers.refused == 0) continue;
      ++refused;
      study.refusals.push_back({.group = group, .planner = p, .why = answers.why});
      const bool serves_none = answers.refused == answers.asked;
      if (serves_none && refused < study.groups.size()) continue;
      Fault fault{.field = item.field + ".name",
                  .message = fmt::format("{} cannot plan {}: it {}", item.planner.name, answers.scenario, answers.why)};
      if (answers.refused > 1) fault.message += fmt::format(" (and it refuses {} more scenarios)", answers.refused - 1);
      faults.report(item.place, std::move(fault));
    }
  }
  std::ranges::stable_sort(study.refusals, {}, &StudyRefusal::group);
}

bool refuses(const Study& study, std::size_t planner, std::size_t group) {
  return std::ranges::any_of(study.refusals,
                             [&](const StudyRefusal& r) { return r.planner == planner && r.group == group; });
}

bool read_reference(const Node* node, StudyFaults& faults) {
  if (node == nullptr || !faults.is_word(*node, "reference")) return false;
  if (node->text == "exact") return true;
  if (node->text != "none")
    faults.report(node->place,
                  {.field = "reference", .value = node->text, .limit = "exact | none", .message = "unknown word"});
  return false;
}

/// Every exact planner of the registry on every scenario that it serves, once.
void add_references(Study& study, const Registry& registry) {
  for (const PlannerEntry& entry : registry.entries()) {
    if (!entry.can.exact) continue;
    std::vector<Fault> none;
    const Preset& preset = entry.presets.front();
    const std::size_t index = study.references.size();
    study.references.push_back({.name = entry.name,
                                .preset = preset.name,
                                .can_on = [&entry](const Site& site) { return entry.can_on(site); },
                                .chance = !entry.can.deterministic,
                                .planner = entry.make(entry.parameters.resolve(preset.values, {}, none))});
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
      if (entry.refuses(Problem(study.scenarios[s].world)).empty())
        study.jobs.push_back({.scenario = s, .planner = index, .reference = true});
    }
  }
}

void add_jobs(Study& study, const std::vector<std::uint64_t>& seeds) {
  for (std::size_t s = 0; s < study.scenarios.size(); ++s)
    for (std::size_t p = 0; p < study.planners.size(); ++p) {
      if (refuses(study, p, study.scenarios[s].group)) continue;
      for (std::size_t b = 0; b < study.budgets.size(); ++b)
        for (std::size_t i = 0; i < (study.planners[p].chance ? seeds.size() : 1); ++i)
          study.jobs.push_back({.scenario = s, .planner = p, .budget = b, .seed = seeds[i]});
    }
}

/// What the files held that a scenario names: ground, maps and points.
void add_contents(const Site& site, Checksum& sum) {
  if (const auto* raster = std::get_if<HeightRaster>(&site.ground)) {
    sum.add_numbers(std::array{raster->area.min.x(), raster->area.min.y(), raster->area.max.x(), raster->area.max.y()});
    sum.add_numbers(raster->posts);
  }
  if (site.grid) {
    sum.add_numbers(site.grid->blocked);
    sum.add_numbers(site.grid->height_m);
  }
  if (site.voxels) site.voxels->for_each_blocked([&](const VoxelCell& cell) { sum.add_numbers(cell); });
  if (!site.navigation) return;
  for (const CorrectionPoint& point : site.navigation->points) {
    sum.add_numbers(std::array{point.id, static_cast<int>(point.kind)});
    sum.add_numbers(std::array{point.position.x(), point.position.y(), point.position.z(), point.success});
  }
}

std::string fingerprint_of(const Study& study, const std::string& text) {
  Checksum sum;
  sum.add(version());
  sum.add("\n");
  sum.add(text);
  for (const StudyScenario& scenario : study.scenarios) {
    sum.add(to_yaml(scenario.world.site().scenario));
    add_contents(scenario.world.site(), sum);
  }
  return sum.text();
}

}  // namespace

Study load_study(const std::string& file, const Registry& registry) {
  StudyFaults faults(file);
  std::string text;
  const Node root = read_root(file, text, faults);
  faults.check_keys(root, "", {"scenarios", "planners", "seeds", "budgets", "reference"});

  Study study{.file = file};
  std::vector<PlannerItem> planners;
  std::vector<std::uint64_t> seeds{kDefaultSeed};
  study.budgets.emplace_back();
  if (const Node* list = root.find("scenarios"); faults.is_list(list, root, "scenarios", kMaxStudyScenarios)) {
    ScenarioItems items = read_study_scenarios(*list, faults);
    study.scenarios = std::move(items.scenarios);
    study.groups = std::move(items.groups);
  }
  if (const Node* list = root.find("planners"); faults.is_list(list, root, "planners", kMaxStudyPlanners))
    planners = read_study_planners(*list, registry, faults);
  if (const Node* node = root.find("seeds"); node != nullptr) seeds = read_study_seeds(*node, faults);
  if (const Node* list = root.find("budgets");
      list != nullptr && faults.is_list(list, root, "budgets", kMaxStudyBudgets))
    study.budgets = read_study_budgets(*list, faults);
  const bool exact = read_reference(root.find("reference"), faults);
  note_refusals(planners, study, faults);
  const std::size_t runs = study.scenarios.size() * planners.size() * study.budgets.size() * seeds.size();
  if (runs > kMaxStudyRuns)
    faults.report(root.place, {.value = fmt::format("{}", runs),
                               .limit = fmt::format("{}", kMaxStudyRuns),
                               .unit = "runs",
                               .message = "the study asks for too many runs"});
  faults.throw_if_any();

  for (PlannerItem& item : planners) study.planners.push_back(std::move(item.planner));
  add_jobs(study, seeds);
  if (exact) add_references(study, registry);
  study.fingerprint = fingerprint_of(study, text);
  return study;
}

}  // namespace alate
