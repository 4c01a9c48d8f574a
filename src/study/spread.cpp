#include "study/spread.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "study/statistics.hpp"

namespace alate {

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  constexpr double kReach = 1.5;
  Spread spread{.lower_quartile = quantile(values, 0.25),
                .median = quantile(values, 0.5),
                .upper_quartile = quantile(values, 0.75)};
  const double reach = kReach * (spread.upper_quartile - spread.lower_quartile);
  const auto first = std::ranges::lower_bound(values, spread.lower_quartile - reach);
  const auto last = std::ranges::upper_bound(values, spread.upper_quartile + reach);
  spread.lower_whisker = *first;
  spread.upper_whisker = *std::prev(last);
  spread.outliers.assign(values.begin(), first);
  spread.outliers.insert(spread.outliers.end(), last, values.end());
  return spread;
}

double lower_median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  std::ranges::sort(values);
  return values[(values.size() - 1) / 2];
}

std::optional<double> mean_margin(const std::vector<double>& values) {
  const auto summary = summarize(values);
  if (!summary || !summary->sd) return std::nullopt;
  constexpr double kUpper = 0.975;
  const auto count = static_cast<double>(values.size());
  const boost::math::students_t distribution(count - 1);
  return quantile(distribution, kUpper) * *summary->sd / std::sqrt(count);
}

}  // namespace alate
