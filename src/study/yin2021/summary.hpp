// What the tables show: methods and readings over all maps of a size.
#pragma once

#include "study/yin2021/figures.hpp"

namespace alate::yin2021 {

/// A method over the maps of a size: means over the maps of what the check measures; `sd` is the root of the mean
/// variance within a map, `lower_bound` the mean exact optimum.
Cell cell_over_maps(const SizeStudy& of_size, const Experiment& experiment, std::size_t method);

/// A method on one map; its bound is the exact optimum.
Cell cell_on_map(const SizeStudy& of_size, std::size_t map, std::string_view method);

/// Means over the maps of what the check measures.
struct MethodSummary {
  Cell cell;
  std::optional<double> height_dev;
  std::optional<double> turns;
  std::optional<double> score;    ///< S.
  std::optional<double> settled;  ///< Iteration of the last change of the length.
};
MethodSummary summarize_method(const SizeStudy& of_size, std::string_view method);

/// What changes from the baseline to the new method under one reading.
struct ReadingSummary {
  std::optional<Interval> length_percent;
  std::optional<Interval> variance_percent;
  std::optional<Interval> score_percent;  ///< As the colony scores.
  std::optional<Interval> turns;
  std::optional<double> li_length;      ///< Cell sides, as the colony measures.
  std::optional<double> true_li_score;  ///< S of the baseline's routes with F over their own cells.
};
ReadingSummary summarize_reading(const Study& study, Size size, std::size_t reading);

}  // namespace alate::yin2021
