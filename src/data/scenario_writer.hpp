// Scenario to YAML text, plain or with comments.
#pragma once

#include <string>

#include "alate/core/scenario.hpp"

namespace alate {

enum class Comments { none, all };

/// Writes all fields that mean something. With comments every key carries its help, and keys that are not given
/// follow as comments, ready to be filled in.
std::string write_scenario(Scenario scenario, Comments comments);

}  // namespace alate
