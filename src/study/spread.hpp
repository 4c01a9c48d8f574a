// How values spread.
#pragma once

#include <optional>
#include <vector>

namespace alate {

/// What a box plot draws: quartiles, and whiskers at the outermost values within 1.5 times the box (Tukey 1977).
struct Spread {
  double lower_whisker = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double upper_whisker = 0;
  std::vector<double> outliers;  ///< Sorted.
};

/// Nothing for no values.
std::optional<Spread> spread_of(std::vector<double> values);

/// Of sorted values, at least one: linear between them (type 7 of Hyndman and Fan 1996).
double quantile(const std::vector<double>& sorted, double share);

/// The lower one of the middle two, as a mean with infinity is none; infinite for no values.
double lower_median(std::vector<double> values);

/// Half the width of the 95 % confidence interval of a mean, by Student's t; nothing below two values.
std::optional<double> mean_margin(const std::vector<double>& values);

}  // namespace alate
