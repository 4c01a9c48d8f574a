// A published route, flown and judged.
#pragma once

#include <vector>

#include "study/zhou2020/study.hpp"

namespace alate::zhou2020 {

/// Errors on arrival, as the paper's table 3 lists them.
struct Arrival {
  std::string where;  ///< "503", "goal".
  PointKind kind = PointKind::end;
  double flown_m = 0;  ///< From the start.
  double vertical = 0;
  double horizontal = 0;
};

struct JudgedRoute {
  Route route;
  Metrics metrics;
  Verdict verdict;
  std::string broken;             ///< Why it cannot be flown, or the first limit it breaks and where; empty: nothing.
  std::vector<Arrival> arrivals;  ///< Empty if it cannot be flown.

  bool feasible() const { return broken.empty(); }
};

/// Flies `ids` through the site and asks `check`.
JudgedRoute judge_route(const Site& site, const std::vector<int>& ids);

/// Errors before each correction of a route and at its end, corrections working as planned.
std::vector<Arrival> arrivals_of(const Site& site, const Route& route);

}  // namespace alate::zhou2020
