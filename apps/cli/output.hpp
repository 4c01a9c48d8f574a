// Runs and verdicts in plain words, for people at a terminal.
#pragma once

#include <string>

#include "alate/out/result.hpp"

namespace alate::cli {

/// What came out of a run: route, sizes, bound, verdict, warnings. Several lines, each ended.
std::string describe(const Result& result);

/// Sizes of a route, one a line.
std::string describe(const Site& site, const Metrics& metrics);

/// Every judged rule with its worst margin and place, every violation, and what was not judged.
std::string describe(const Site& site, const Verdict& verdict);

/// Which heights are meant, and what the terrain does not hold.
std::string height_note(const Site& site);

}  // namespace alate::cli
