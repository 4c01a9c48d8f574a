// What the runs of a comparison say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/study/compare.hpp"
#include "study/statistics.hpp"

namespace alate {

/// One contender when one time was up, over its seeds.
struct CompareFigures {
  std::size_t contender = 0;
  std::size_t runs = 0;
  std::size_t refused = 0, late = 0, none = 0;
  std::vector<double> costs;       ///< Of routes that pass, by seed.
  std::optional<Summary> cost;     ///< Of the same.
  double median = 0;               ///< Of all runs, the lower one; one without a route that passes counts as infinite.
  const CompareRun* typical = {};  ///< The run of that cost; else the first with a route; null if none has one.

  bool solves() const;  ///< Has the median run a route that passes?
};

CompareFigures figures_of(const Comparison& comparison, std::size_t contender, std::size_t time);

/// All contenders at one time, by their medians.
std::vector<CompareFigures> ranking(const Comparison& comparison, std::size_t time);

/// Cost of the cheapest route of all runs and times that passes; nothing if none does.
std::optional<double> best_cost(const Comparison& comparison);

/// Plain sentences: who is best when, who is not, and what the check says of the others.
std::vector<std::string> findings(const Comparison& comparison);

/// Five digits or more, one of them behind the point at least; a dash for what is not finite.
std::string cost_words(double cost);

/// "0.1 s", "30 ms".
std::string time_words(double seconds);

}  // namespace alate
