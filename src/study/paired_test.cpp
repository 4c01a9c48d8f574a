#include "study/paired_test.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>

namespace alate {

namespace {

/// Twice the rank of each size, so that shared ranks are whole numbers too. `sizes` are sorted.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& sizes) {
  std::vector<std::size_t> ranks;
  for (std::size_t begin = 0; begin < sizes.size();) {
    std::size_t end = begin;
    while (end < sizes.size() && sizes[end] == sizes[begin]) ++end;
    ranks.insert(ranks.end(), end - begin, begin + end + 1);
    begin = end;
  }
  return ranks;
}

/// Chance that the ranks which fall to one side, each with even odds, sum up to `sum` at most.
double exact_lower_tail(const std::vector<std::size_t>& ranks, std::size_t sum) {
  std::vector<double> chance(std::accumulate(ranks.begin(), ranks.end(), std::size_t{0}) + 1, 0.0);
  chance[0] = 1;
  for (const std::size_t rank : ranks)
    for (std::size_t i = chance.size(); i-- > 0;) chance[i] = 0.5 * (chance[i] + (i >= rank ? chance[i - rank] : 0));
  return std::accumulate(chance.begin(), chance.begin() + static_cast<std::ptrdiff_t>(sum) + 1, 0.0);
}

double normal_lower_tail(const std::vector<std::size_t>& ranks, std::size_t sum) {
  double mean = 0;
  double variance = 0;
  for (const std::size_t rank : ranks) {
    const auto value = static_cast<double>(rank);
    mean += value / 2;
    variance += value * value / 4;
  }
  constexpr double kContinuity = 1;  // Half a rank, doubled.
  return cdf(boost::math::normal(), (static_cast<double>(sum) + kContinuity - mean) / std::sqrt(variance));
}

}  // namespace

SignedRank signed_rank(const std::vector<double>& differences) {
  std::vector<double> signs;
  std::ranges::copy_if(differences, std::back_inserter(signs), [](double each) { return each != 0; });
  if (signs.empty()) return {};
  std::ranges::sort(signs, {}, [](double each) { return std::abs(each); });
  std::vector<double> sizes;
  for (const double each : signs) sizes.push_back(std::abs(each));
  const std::vector<std::size_t> ranks = doubled_ranks(sizes);
  std::size_t above = 0;
  std::size_t below = 0;
  for (std::size_t i = 0; i < signs.size(); ++i) (signs[i] > 0 ? above : below) += ranks[i];
  const std::size_t least = std::min(above, below);
  const double tail = signs.size() <= kExactPairs ? exact_lower_tail(ranks, least) : normal_lower_tail(ranks, least);
  return {.pairs = signs.size(), .below = below > above, .p = std::min(1.0, 2 * tail)};
}

std::vector<double> holm(const std::vector<double>& chances) {
  std::vector<std::size_t> order(chances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return chances[i]; });
  std::vector<double> corrected(chances.size());
  double most = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    most = std::max(most, std::min(1.0, static_cast<double>(order.size() - i) * chances[order[i]]));
    corrected[order[i]] = most;
  }
  return corrected;
}

}  // namespace alate
