#include "alate/core/scenario.hpp"

#include <tuple>

namespace alate {

namespace {

auto asked(const Scenario& s) {
  return std::tie(s.frame, s.terrain, s.grid, s.start, s.goal, s.vehicle, s.threats, s.objective, s.navigation,
                  s.planner);
}

}  // namespace

bool Scenario::operator==(const Scenario& other) const { return asked(*this) == asked(other); }

Mark mark_of(const Scenario& scenario, const std::string& field) {
  std::string path = field;
  while (!path.empty()) {
    if (const auto found = scenario.marks.find(path); found != scenario.marks.end()) return found->second;
    const std::size_t dot = path.rfind('.');
    path.resize(dot == std::string::npos ? 0 : dot);
  }
  return {.file = scenario.file};
}

}  // namespace alate
