// Figures over the runs of one method.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace alate {

struct Summary {
  std::size_t count = 0;
  double mean = 0;
  std::optional<double> sd;  ///< Of the sample, divided by n - 1; nothing for a single value.
  double least = 0;
  double greatest = 0;
};

/// Nothing for no values. Sums run in order.
std::optional<Summary> summarize(const std::vector<double>& values);

}  // namespace alate
