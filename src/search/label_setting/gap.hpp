// Why no route leads to the goal: the gap that cannot be crossed.
#pragma once

#include <string>

#include "alate/core/run_context.hpp"
#include "space/correction_graph.hpp"

namespace alate {

/// One plain sentence for a graph without any route: how many points can be reached from the start, and the leg that is
/// wanting least, from one of these to a point that leads on to the goal: its length against what the error limits (and
/// which) allow there, or that ground, ceilings, cores or climb limits close it.
std::string describe_gap(const CorrectionGraph& graph, RunContext& run);

}  // namespace alate
