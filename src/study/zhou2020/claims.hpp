// The verdict on every published route.
#pragma once

#include "study/zhou2020/judged_route.hpp"

namespace alate::zhou2020 {

/// A published row beside what it is found to be.
struct JudgedRow {
  const PublishedRoute* published = nullptr;
  std::optional<JudgedRoute> judged;  ///< Nothing where no route is printed.
  std::optional<double> bound_m;      ///< No route with as many corrections and as good a chance is shorter.
  std::optional<double> gap;          ///< Of the true length to the proven optimum; nothing if infeasible.
  Claim claim;
};

/// Every row, judged.
std::vector<JudgedRow> judge_rows(const Study& study);

}  // namespace alate::zhou2020
