// How a colony went, iteration by iteration.
#pragma once

#include <string>
#include <vector>

#include "alate/world/problem.hpp"

namespace alate {

/// Two diagrams over the iterations: best so far, best, mean and worst cost of the ants that arrived; and the shares of
/// ants that arrived and of moves onto a known trail. Empty without a history.
std::string history_figure(const std::vector<IterationStats>& history);

}  // namespace alate
