// What must hold between the fields of a scenario.
#pragma once

#include <vector>

#include "alate/core/fault.hpp"
#include "alate/core/scenario.hpp"

namespace alate {

/// Reports every pair of fields that contradict each other, at the marks of the scenario. Fields that already have
/// a fault in `faults` are passed over.
void check_rules(const Scenario& scenario, std::vector<Fault>& faults);

}  // namespace alate
