#include "alate/core/scenario.hpp"

#include <tuple>

namespace alate {

namespace {

auto asked(const Scenario& s) {
  return std::tie(s.frame, s.terrain, s.start, s.goal, s.vehicle, s.threats, s.objective, s.planner);
}

}  // namespace

bool Scenario::operator==(const Scenario& other) const { return asked(*this) == asked(other); }

}  // namespace alate
