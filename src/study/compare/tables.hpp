// The tables of a comparison's page.
#pragma once

#include <string>
#include <vector>

#include "study/compare/figures.hpp"

namespace alate {

using Ranking = std::vector<CompareFigures>;

/// Name of a contender, and whether it is a program of others.
std::string shown_name(const Comparison& comparison, const CompareFigures& each);

/// What the check says of each, and its costs, when all time was up.
std::string final_table(const Comparison& comparison, const Ranking& ranks);
/// Medians at all times.
std::string times_table(const Comparison& comparison, const Ranking& ranks);
/// Runs whose route the check refuses, or whose program ended badly.
std::string broken_table(const Comparison& comparison, const Ranking& ranks);
/// Planners that took no part, and why.
std::string absent_table(const Comparison& comparison);

}  // namespace alate
