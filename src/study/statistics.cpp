#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace alate {

std::optional<Summary> summarize(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const auto [least, greatest] = std::ranges::minmax(values);
  return Summary{.count = values.size(),
                 .mean = mean,
                 .sd = values.size() > 1 ? std::optional(std::sqrt(squares / (count - 1))) : std::nullopt,
                 .least = least,
                 .greatest = greatest};
}

}  // namespace alate
