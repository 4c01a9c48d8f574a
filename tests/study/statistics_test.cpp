#include "study/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace alate {
namespace {

TEST(Statistics, OfASample) {
  const auto summary = summarize({2, 4, 4, 6});
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->count, 4U);
  EXPECT_DOUBLE_EQ(summary->mean, 4);
  EXPECT_DOUBLE_EQ(*summary->sd, std::sqrt(8.0 / 3));
  EXPECT_DOUBLE_EQ(summary->least, 2);
  EXPECT_DOUBLE_EQ(summary->greatest, 6);
}

TEST(Statistics, OneValueHasNoSpreadAndNoneNothing) {
  EXPECT_FALSE(summarize({7})->sd);
  EXPECT_DOUBLE_EQ(summarize({7})->mean, 7);
  EXPECT_FALSE(summarize({}));
}

}  // namespace
}  // namespace alate
