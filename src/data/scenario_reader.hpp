// From the tree of a YAML document to the scenario, collecting every fault.
#pragma once

#include <string>
#include <vector>

#include "alate/core/scenario.hpp"
#include "data/scenario_document.hpp"

namespace alate {

inline constexpr const char* kOverrideFile = "--override";

/// Fills `scenario` and its marks from `root`, by the table of fields. `scenario.file` must be set: faults name it
/// and relative paths start at its folder. Faults: unknown keys, missing keys, wrong types, numbers out of range,
/// keys that do not go together.
void read_scenario(const Node& root, Scenario& scenario, std::vector<Fault>& faults);

/// A scenario that stands as a map inside another document, `file`. Complete but for faults, which are as
/// parse_scenario's.
Scenario scenario_of(const Node& root, const std::string& file, std::vector<Fault>& faults);

}  // namespace alate
