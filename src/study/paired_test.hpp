// Paired comparisons and their correction for how many there are.
#pragma once

#include <cstddef>
#include <vector>

namespace alate {

/// Wilcoxon's signed-rank test (Wilcoxon 1945), two-sided. Differences of zero are left out; equal sizes share their
/// mean rank. Infinite differences are the largest. Exact up to kExactPairs differences, given their ties; beyond,
/// the normal approximation with the correction for ties and continuity.
struct SignedRank {
  std::size_t pairs = 0;  ///< Differences that are not zero.
  double p = 1;           ///< That a sum of ranks so uneven comes of chance.
};

inline constexpr std::size_t kExactPairs = 100;

SignedRank signed_rank(const std::vector<double>& differences);

/// Holm's step-down correction (Holm 1979): chances in the order given, so that all of them together are wrong with at
/// most the level that each is held against.
std::vector<double> holm(const std::vector<double>& chances);

}  // namespace alate
