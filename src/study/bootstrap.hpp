// How sure a figure over cases is.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace alate {

/// A figure and its 95 % confidence interval.
struct Interval {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// A figure of some of the cases, by their indices; a case may come several times.
using CaseStatistic = std::function<double(std::span<const std::size_t>)>;

/// Percentile bootstrap (Efron 1979) over `count` cases: 2000 samples of as many cases, drawn with putting back; sample
/// s draws from Stream(1, s, 0), so the same cases give the same bits. Samples where the figure is not a number are
/// left out. Nothing below two cases, or where the figure of all cases is not a number.
std::optional<Interval> bootstrap(std::size_t count, const CaseStatistic& statistic);

/// Of the mean.
std::optional<Interval> mean_interval(std::span<const double> values);

/// Of the sum of `upper` over the sum of `lower`; both have a value a case.
std::optional<Interval> ratio_interval(std::span<const double> upper, std::span<const double> lower);

}  // namespace alate
