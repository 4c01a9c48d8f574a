#include "study/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

TEST(Bootstrap, NeedsTwoCasesAndANumber) {
  EXPECT_FALSE(mean_interval(std::vector<double>{}));
  EXPECT_FALSE(mean_interval(std::vector<double>{3}));
  EXPECT_FALSE(ratio_interval(std::vector<double>{1, 2}, std::vector<double>{0, 0}));
}

TEST(Bootstrap, EqualValuesLeaveNoDoubt) {
  const auto interval = mean_interval(std::vector<double>{4, 4, 4});
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->value, 4);
  EXPECT_EQ(interval->low, 4);
  EXPECT_EQ(interval->high, 4);
}

/// Of uniform values in [0, 1): mean 0.5, standard deviation sqrt(1/12); the interval is that of the normal law.
TEST(Bootstrap, IntervalOfAMeanIsTwoStandardErrorsToBothSides) {
  constexpr std::size_t kValues = 400;
  Stream stream(7, 0, 0);
  std::vector<double> values(kValues);
  for (double& value : values) value = stream.uniform();
  const auto interval = mean_interval(values);
  ASSERT_TRUE(interval);
  const double half = 1.96 * std::sqrt(1.0 / 12) / std::sqrt(static_cast<double>(kValues));
  EXPECT_NEAR(interval->value - interval->low, half, 0.15 * half);
  EXPECT_NEAR(interval->high - interval->value, half, 0.15 * half);
}

TEST(Bootstrap, RatioIsOfSums) {
  const auto interval = ratio_interval(std::vector<double>{1, 3, 2}, std::vector<double>{2, 6, 4});
  ASSERT_TRUE(interval);
  EXPECT_DOUBLE_EQ(interval->value, 0.5);
  EXPECT_DOUBLE_EQ(interval->low, 0.5);
}

TEST(Bootstrap, LeavesOutSamplesWithoutANumber) {
  const auto interval = ratio_interval(std::vector<double>{1, 1}, std::vector<double>{0, 1});
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->value, 2);
  EXPECT_EQ(interval->low, 1);
  EXPECT_EQ(interval->high, 2);
}

}  // namespace
}  // namespace alate
