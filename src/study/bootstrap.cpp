#include "study/bootstrap.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "alate/core/stream.hpp"

namespace alate {

namespace {

constexpr std::size_t kSamples = 2000;
constexpr double kTail = 0.025;

double sum_of(std::span<const double> values, std::span<const std::size_t> cases) {
  double sum = 0;
  for (const std::size_t i : cases) sum += values[i];
  return sum;
}

/// The value that a share of the sorted ones lies below.
double percentile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))];
}

}  // namespace

std::optional<Interval> bootstrap(std::size_t count, const CaseStatistic& statistic) {
  constexpr std::uint64_t kSeed = 1;
  if (count < 2) return std::nullopt;
  std::vector<std::size_t> cases(count);
  std::iota(cases.begin(), cases.end(), std::size_t{0});
  const double value = statistic(cases);
  if (!std::isfinite(value)) return std::nullopt;
  std::vector<double> figures;
  for (std::size_t sample = 0; sample < kSamples; ++sample) {
    Stream stream(kSeed, sample, 0);
    for (std::size_t& drawn : cases) drawn = static_cast<std::size_t>(stream.below(count));
    if (const double figure = statistic(cases); std::isfinite(figure)) figures.push_back(figure);
  }
  if (figures.empty()) return std::nullopt;
  std::ranges::sort(figures);
  return Interval{.value = value, .low = percentile(figures, kTail), .high = percentile(figures, 1 - kTail)};
}

std::optional<Interval> mean_interval(std::span<const double> values) {
  return bootstrap(values.size(), [&](std::span<const std::size_t> cases) {
    return sum_of(values, cases) / static_cast<double>(cases.size());
  });
}

std::optional<Interval> ratio_interval(std::span<const double> upper, std::span<const double> lower) {
  assert(upper.size() == lower.size());
  return bootstrap(upper.size(),
                   [&](std::span<const std::size_t> cases) { return sum_of(upper, cases) / sum_of(lower, cases); });
}

}  // namespace alate
