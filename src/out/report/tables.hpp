// The tables of the report, as HTML.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "alate/out/result.hpp"

namespace alate {

/// Two columns, name and value. Values are HTML already; names are escaped.
std::string pairs_table(const std::vector<std::pair<std::string, std::string>>& rows);

/// Every rule: judged or not, limit, worst margin and where.
std::string rules_table(const Result& result);

/// Cost, bound, sizes, work done.
std::string numbers_table(const Result& result);

/// Planner, parameters, seed, and whatever else is needed to make the same route again.
std::string settings_table(const Result& result);

}  // namespace alate
