// What the runs of a study say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "alate/study/study.hpp"
#include "study/spread.hpp"
#include "study/statistics.hpp"

namespace alate {

/// What costs are measured against, the same for the whole study.
enum class Yardstick { optimum, lower_bound, best_found };

/// "the optimum", ...
const char* words_of(Yardstick yardstick);

/// One planner with one budget, over all scenarios and seeds. Gaps are percent above the yardstick, of valid routes.
struct MethodFigures {
  std::size_t planner = 0;
  std::size_t budget = 0;
  std::string name;  ///< "grid-aco improved".
  std::size_t runs = 0;
  std::vector<double> gaps;
  std::optional<Summary> gap;
  std::optional<double> gap_margin;  ///< 95 % confidence, of the mean.
  double mean_s = 0;
  std::vector<const StudyRecord*> records;  ///< By scenario, then seed.
  std::vector<double> bases;                ///< Yardstick of each.
};

/// Two methods with one budget, by Wilcoxon's signed-rank test.
struct MethodDuel {
  std::size_t first = 0;  ///< Of `methods`.
  std::size_t second = 0;
  std::size_t pairs = 0;
  std::size_t first_better = 0;
  std::size_t second_better = 0;
  double p = 1;          ///< Before correction.
  double corrected = 1;  ///< Holm, over all duels of the study.
};

struct StudyAnalysis {
  Yardstick yardstick = Yardstick::best_found;
  std::vector<MethodFigures> methods;  ///< By budget, then planner.
  std::vector<MethodDuel> duels;
  bool by_scenario = false;  ///< A pair is a scenario, with the median over its seeds; else one scenario and seed.
};

/// `study` and `records` must live as long as the analysis.
StudyAnalysis analyse(const Study& study, const StudyRecords& records);

/// "grid-aco improved, iterations=40"; without the budget where the study has one only.
std::string full_name(const Study& study, const MethodFigures& method);

}  // namespace alate
