// The exact front of length, corrections and probability of success.
#pragma once

#include "search/label_setting/front.hpp"

namespace alate {

/// Zhou et al. 2020, problem 3, solved exactly. `routes` come by corrections, then length; no other route is at least
/// as good in all three. First the front of routes that cannot fail: those that keep all limits when every correction
/// that may fail does, which is the worst case as errors only grow. No route that may fail is of use beyond its
/// lengths. Then labels with all their cases, layer by layer.
FrontResult chance_front(const CorrectionGraph& graph, RunContext& run);

}  // namespace alate
