#include "alate/core/stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace alate {
namespace {

TEST(Stream, IsAFunctionOfItsKey) {
  Stream a(1, 2, 3);
  Stream b(1, 2, 3);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Stream, NeighbouringKeysShareNothing) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (std::uint64_t iteration = 0; iteration < 8; ++iteration)
      for (std::uint64_t ant = 0; ant < 8; ++ant) {
        Stream stream(seed, iteration, ant);
        for (int draw = 0; draw < 16; ++draw) EXPECT_TRUE(seen.insert(stream.bits()).second);
      }
}

TEST(Stream, UniformFillsTheUnitIntervalEvenly) {
  std::array<int, 10> tenths{};
  for (std::uint64_t ant = 0; ant < 1000; ++ant) {
    Stream stream(7, 0, ant);
    for (int draw = 0; draw < 100; ++draw) {
      const double value = stream.uniform();
      ASSERT_GE(value, 0);
      ASSERT_LT(value, 1);
      ++tenths[static_cast<std::size_t>(value * 10)];
    }
  }
  // 10000 expected in each; the standard deviation is 95.
  for (const int count : tenths) EXPECT_NEAR(count, 10000, 500);
}

TEST(Stream, BelowReachesEveryNumberAndNoOther) {
  Stream stream(1, 1, 1);
  std::set<std::uint64_t> seen;
  for (int draw = 0; draw < 500; ++draw) seen.insert(stream.below(7));
  EXPECT_EQ(seen, (std::set<std::uint64_t>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(stream.below(1), 0U);
}

}  // namespace
}  // namespace alate
