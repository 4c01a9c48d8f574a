// The rules of the check in words.
#pragma once

#include <string>
#include <string_view>

#include "alate/data/site.hpp"

namespace alate {

/// "terrain_clearance" -> "Height above ground"; the name itself for rules without words.
std::string rule_title(std::string_view rule);

/// What the scenario asks for, "at least 60 m"; empty where a plain limit says too little.
std::string rule_limit(std::string_view rule, const Site& site);

}  // namespace alate
