// Four ants side by side against one at a time.
#include "aco/walk/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/grid_stands.hpp"

namespace alate {
namespace {

using Row = std::array<float, 8>;
using Rows = std::array<Row, kAntLanes>;

/// Weights of very different sizes, some of them 0.
Rows drawn_rows(Stream& stream) {
  Rows rows{};
  for (Row& row : rows)
    for (float& value : row)
      if (stream.below(3) != 0) value = static_cast<float>(stream.uniform() * (stream.below(2) == 0 ? 1e-6 : 10));
  return rows;
}

MoveLanes lanes_of(const Rows& rows) {
  return load_rows({rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data()});
}

TEST(Lanes, HoldARowEach) {
  Stream stream(3, 1, 1);
  const Rows rows = drawn_rows(stream);
  const MoveLanes lanes = lanes_of(rows);
  for (std::size_t i = 0; i < kAntLanes; ++i)
    for (std::size_t d = 0; d < 8; ++d) EXPECT_EQ(lanes[d][i], rows[i][d]);
}

TEST(Lanes, PickByTheRunningSum) {
  Stream stream(1, 1, 1);
  int picked = 0;
  for (int round = 0; round < 20000; ++round) {
    const Rows rows = drawn_rows(stream);
    const LaneFloats uniform = draw_uniform({&stream, &stream, &stream, &stream});
    const LaneBits directions = pick(lanes_of(rows), uniform);
    for (std::size_t i = 0; i < kAntLanes; ++i) {
      const Row& row = rows[i];
      const auto direction = static_cast<std::size_t>(directions[i]);
      double sum = 0;
      for (const float value : row) sum += double{value};
      ASSERT_EQ(direction == 8, sum == 0);
      if (direction == 8) continue;
      ++picked;
      ASSERT_GT(row[direction], 0) << "a weight of 0 is never drawn";
      double until = 0;
      for (std::size_t d = 0; d < direction; ++d) until += double{row[d]};
      const double point = sum * double{uniform[i]};
      EXPECT_LE(until, point + 1e-6 * sum);
      EXPECT_GT(until + double{row[direction]}, point - 1e-6 * sum);
    }
  }
  EXPECT_GT(picked, 70000);
}

TEST(Lanes, PickBothEndsOfTheRange) {
  const Row row{0, 3, 0, 0, 1, 0.1F, 0, 0};
  constexpr float kMost = 1 - 0x1.0p-24F;
  const LaneBits directions = pick(lanes_of({row, row, row, row}), LaneFloats{0, kMost, 0, kMost});
  EXPECT_EQ(directions[0], 1);
  EXPECT_EQ(directions[1], 5);
}

TEST(Lanes, HeaviestIsTheFirstOfEqualOnes) {
  Stream stream(2, 1, 1);
  for (int round = 0; round < 10000; ++round) {
    Rows rows{};
    for (Row& row : rows)
      for (float& value : row) value = static_cast<float>(stream.below(round == 0 ? 1 : 4));
    const LaneBits directions = heaviest(lanes_of(rows));
    for (std::size_t i = 0; i < kAntLanes; ++i) {
      const float most = std::ranges::max(rows[i]);
      ASSERT_EQ(directions[i], most > 0 ? std::ranges::find(rows[i], most) - rows[i].begin() : 8);
    }
  }
}

TEST(GridStands, KnowWhatIsLeft) {
  for (unsigned tabu = 0; tabu < 256; ++tabu) {
    const GridStands at = test::stands_at({.cell = 1, .tabu = tabu});
    for (unsigned d = 0; d < 8; ++d)
      for (std::size_t i = 0; i < kAntLanes; ++i) EXPECT_EQ(at.left(d)[i], ((tabu >> d) & 1U) != 0 ? 0 : -1);
  }
}

}  // namespace
}  // namespace alate
