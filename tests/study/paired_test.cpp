// Paired tests, spreads and intervals against published or hand-made values.
#include "study/paired_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "study/spread.hpp"

namespace alate {

namespace {

TEST(SignedRank, IsExactForFewPairs) {
  // Five differences of one sign: 2 / 2^5.
  const SignedRank all = signed_rank({1, 2, 3, 4, 5});
  EXPECT_EQ(all.pairs, 5U);
  EXPECT_FALSE(all.below);
  EXPECT_DOUBLE_EQ(all.p, 0.0625);
  // The lesser rank sum of 6 pairs is 2, from {} {1} {2}: 2 * 3 / 2^6.
  EXPECT_DOUBLE_EQ(signed_rank({-1, 2, -3, -4, -5, -6}).p, 2.0 * 3 / 64);
  EXPECT_TRUE(signed_rank({-1, 2, -3, -4, -5, -6}).below);
}

TEST(SignedRank, LeavesOutZerosAndSharesRanks) {
  EXPECT_EQ(signed_rank({0, 0}).pairs, 0U);
  EXPECT_DOUBLE_EQ(signed_rank({0, 0}).p, 1);
  // Sizes 1, 1, 1: three shared ranks of 2; one of them below: sums 0 and 2 of 8 cases are 1 + 3.
  EXPECT_DOUBLE_EQ(signed_rank({1, 1, -1, 0}).p, 1);
  EXPECT_DOUBLE_EQ(signed_rank({1, 1, 1}).p, 0.25);
}

TEST(SignedRank, TakesInfiniteDifferences) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(signed_rank({1, 2, 3, infinity, infinity}).p, 0.0625);
}

TEST(SignedRank, IsCloseToNormalForManyPairs) {
  std::vector<double> exact;
  for (std::size_t i = 1; i <= kExactPairs; ++i) exact.push_back((i % 3 == 0 ? -1.0 : 1.0) * static_cast<double>(i));
  std::vector<double> more = exact;
  more.push_back(0.5);  // One pair beyond: the approximation.
  EXPECT_NEAR(signed_rank(more).p / signed_rank(exact).p, 1, 0.15);
}

TEST(Holm, StepsDown) {
  // The example of Holm's step-down: sorted 0.01, 0.02, 0.03, 0.04 times 4, 3, 2, 1, never falling.
  const std::vector<double> corrected = holm({0.03, 0.01, 0.04, 0.02});
  const std::vector<double> expected{0.06, 0.04, 0.06, 0.06};
  ASSERT_EQ(corrected.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(corrected[i], expected[i], 1e-12);
  EXPECT_DOUBLE_EQ(holm({0.9, 0.8})[0], 1);
}

TEST(Spread, HasQuartilesWhiskersAndOutliers) {
  const auto spread = spread_of({1, 2, 3, 4, 100});
  ASSERT_TRUE(spread);
  EXPECT_DOUBLE_EQ(spread->lower_quartile, 2);
  EXPECT_DOUBLE_EQ(spread->median, 3);
  EXPECT_DOUBLE_EQ(spread->upper_quartile, 4);
  EXPECT_DOUBLE_EQ(spread->lower_whisker, 1);
  EXPECT_DOUBLE_EQ(spread->upper_whisker, 4);
  EXPECT_EQ(spread->outliers, std::vector<double>{100});
  EXPECT_FALSE(spread_of({}));
}

TEST(MeanMargin, IsStudents) {
  // t(0.975; 4) = 2.776445, standard deviation of 1..5 = 1.581139.
  EXPECT_NEAR(*mean_margin({1, 2, 3, 4, 5}), 2.776445105 * std::sqrt(2.5 / 5), 1e-6);
  EXPECT_FALSE(mean_margin({1}));
}

}  // namespace

}  // namespace alate
