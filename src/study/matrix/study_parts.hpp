// The parts of a study file, each read from its node.
#pragma once

#include <string>
#include <vector>

#include "alate/study/study.hpp"
#include "study/matrix/study_faults.hpp"

namespace alate {

/// A planner of the file, and where its name stands.
struct PlannerItem {
  StudyPlanner planner;
  const PlannerEntry* entry = nullptr;
  Place place;
  std::string field;
};

/// Scenarios, and their groups' names.
struct ScenarioItems {
  std::vector<StudyScenario> scenarios;
  std::vector<std::string> groups;
};

ScenarioItems read_study_scenarios(const Node& list, StudyFaults& faults);
std::vector<PlannerItem> read_study_planners(const Node& list, const Registry& registry, StudyFaults& faults);
std::vector<std::uint64_t> read_study_seeds(const Node& node, StudyFaults& faults);
std::vector<StudyBudget> read_study_budgets(const Node& list, StudyFaults& faults);

/// Name of the planner, then of the preset, then the parameters that were set.
std::string label_of(const StudyPlanner& planner);

}  // namespace alate
