// The tables of the reproduction page, as HTML.
#pragma once

#include <string>
#include <vector>

#include "study/zhou2020/claims.hpp"

namespace alate::zhou2020 {

/// Every published route: claimed and true length, corrections, where it breaks, chance, gap to the optimum.
std::string routes_table(const std::vector<JudgedRow>& rows);

/// Like the paper's tables 2 and 3: both errors before each correction of the shortest proven route.
std::string errors_table(const Study& study, std::size_t set, Task task);

/// The whole proven front of a problem.
std::string front_table(const Study& study, std::size_t set, Task task);

/// Like the paper's table 5: its four A* runs beside ours.
std::string astar_table(const Study& study);

/// Every method on problem 1: share of runs that found a route, mean, spread, best, gap to the optimum, time.
std::string methods_table(const Study& study);

}  // namespace alate::zhou2020
