// Everything a program needs to plan, check and write routes.
#pragma once

#include "alate/check/check.hpp"         // IWYU pragma: export
#include "alate/core/version.hpp"        // IWYU pragma: export
#include "alate/data/route_file.hpp"     // IWYU pragma: export
#include "alate/data/scenario_file.hpp"  // IWYU pragma: export
#include "alate/data/site.hpp"           // IWYU pragma: export
#include "alate/out/result.hpp"          // IWYU pragma: export
#include "alate/plan/planner.hpp"        // IWYU pragma: export
#include "alate/plan/registry.hpp"       // IWYU pragma: export
#include "alate/plan/session.hpp"        // IWYU pragma: export
#include "alate/world/world.hpp"         // IWYU pragma: export
