#include "data/site_faults.hpp"

namespace alate {

namespace {

/// Where `field`, or the nearest thing around it, stands in the text.
Mark place_of(const Scenario& scenario, std::string field) {
  while (!field.empty()) {
    if (const auto found = scenario.marks.find(field); found != scenario.marks.end()) return found->second;
    const auto dot = field.rfind('.');
    field.resize(dot == std::string::npos ? 0 : dot);
  }
  return {.file = scenario.file};
}

}  // namespace

void SiteFaults::add(Fault fault) {
  const Mark mark = place_of(scenario_, fault.field);
  fault.file = mark.file;
  fault.line = mark.line;
  fault.column = mark.column;
  faults_.push_back(std::move(fault));
}

}  // namespace alate
