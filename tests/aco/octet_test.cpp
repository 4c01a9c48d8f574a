// Eight values side by side against the same one by one.
#include "aco/transition/octet.hpp"

#include <gtest/gtest.h>

#include <array>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

using Row = std::array<float, 8>;

/// Weights of very different sizes, some of them 0.
Row drawn_row(Stream& stream) {
  Row row{};
  for (float& value : row)
    if (stream.below(3) != 0) value = stream.uniform_float() * (stream.below(2) == 0 ? 1e-6F : 10.0F);
  return row;
}

TEST(Octet, DrawsByTheRunningSum) {
  Stream stream(1, 1, 1);
  int drawn = 0;
  for (int i = 0; i < 100000; ++i) {
    const Row row = drawn_row(stream);
    const float uniform = stream.uniform_float();
    double sum = 0;
    for (const float value : row) sum += double{value};
    const unsigned direction = draw(Octet::load(row.data()), uniform);
    ASSERT_EQ(direction == 8, sum == 0);
    if (direction == 8) continue;
    ++drawn;
    ASSERT_GT(row[direction], 0) << "a weight of 0 is never drawn";
    double until = 0;
    for (unsigned d = 0; d < direction; ++d) until += double{row[d]};
    EXPECT_LE(until, sum * double{uniform} + 1e-6 * sum);
    EXPECT_GT(until + double{row[direction]}, sum * double{uniform} - 1e-6 * sum);
  }
  EXPECT_GT(drawn, 90000);
}

TEST(Octet, DrawsTheLastWeightAtTheEndOfTheRange) {
  const Row row{0, 3, 0, 0, 1, 0.1F, 0, 0};
  constexpr float kMost = 1 - 0x1.0p-24F;
  EXPECT_EQ(draw(Octet::load(row.data()), 0), 1U);
  EXPECT_EQ(draw(Octet::load(row.data()), kMost), 5U);
}

TEST(Octet, HeaviestIsTheFirstOfEqualOnes) {
  Stream stream(2, 1, 1);
  for (int i = 0; i < 10000; ++i) {
    Row row{};
    for (float& value : row) value = static_cast<float>(stream.below(4));
    unsigned first = 8;
    float most = 0;
    for (unsigned d = 0; d < 8; ++d) {
      if (row[d] <= most) continue;
      most = row[d];
      first = d;
    }
    ASSERT_EQ(heaviest(Octet::load(row.data())), first);
  }
  EXPECT_EQ(heaviest(Octet::all(0)), 8U);
}

TEST(Octet, MasksKeepTheirMembers) {
  for (unsigned members = 0; members < 256; ++members) {
    const Octet kept = OctetMask::of(members).keep(Octet::all(2));
    const Octet left = OctetMask::of(members).others().keep(Octet::all(2));
    for (unsigned d = 0; d < 8; ++d) {
      EXPECT_EQ(kept[d], ((members >> d) & 1U) != 0 ? 2 : 0);
      EXPECT_EQ(left[d], 2 - kept[d]);
    }
  }
}

}  // namespace
}  // namespace alate
