// Drawings of a study.
#pragma once

#include <string>

#include "study/matrix/analysis.hpp"

namespace alate {

/// Planners beyond these share the colours of the first ones, so curves are drawn of these only.
inline constexpr std::size_t kLineStyles = 6;

/// "w0", ..., by planner.
std::string line_class(const MethodFigures& method);

/// Gaps of every planner with one budget as box plots; empty if there are none.
std::string box_svg(const Study& study, const StudyAnalysis& analysis, std::size_t budget);

/// Median and quartiles over all runs, iteration by iteration; empty for planners without history, or whose own sum is
/// not the cost.
std::string bands_svg(const Study& study, const StudyAnalysis& analysis, std::size_t budget);

/// Does the planner tell its history in the costs that count? False for one that minimises something else.
bool has_bands(const MethodFigures& method);

/// Mean gap with its confidence interval over mean planning time, budgets of one planner joined; empty without gaps.
std::string gap_time_svg(const StudyAnalysis& analysis);

/// Style of lines w3, w4, w5 and of boxes.
extern const std::string_view kViewStyle;

}  // namespace alate
