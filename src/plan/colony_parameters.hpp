// Parameters that all colonies share; what differs is the default, and sometimes the source.
#pragma once

#include <cstdint>
#include <string>

#include "alate/core/param_table.hpp"

namespace alate {

Parameter ants_parameter(std::int64_t ants, std::string source);
Parameter iterations_parameter(std::int64_t iterations, std::string source);
Parameter spread_parameter(double spread);
Parameter follow_parameter(double share);
Parameter give_up_parameter(double share);
Parameter step_backs_parameter(std::int64_t most);
Parameter alpha_parameter(std::string source);
Parameter evaporation_parameter(double share, std::string source);
Parameter trail_ratio_parameter();
Parameter best_every_parameter();

}  // namespace alate
