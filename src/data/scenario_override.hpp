// Changes to a scenario file from the command line.
#pragma once

#include <string>
#include <vector>

#include "data/scenario_document.hpp"

namespace alate {

/// Applies one `key.path=VALUE`, VALUE in YAML. Missing groups and lists are made; an item is added to a list by the
/// index equal to its size. All that is set has line 0. Faults: bad syntax, a path through a plain value, an index
/// beyond the list.
void apply_override(const std::string& text, Node& root, std::vector<Fault>& faults);

}  // namespace alate
