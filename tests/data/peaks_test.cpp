#include "alate/data/peaks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "alate/core/stream.hpp"

namespace alate {
namespace {

// Tables 1 and 2 of Mai et al. 2023, in km.
PeakGround simple() { return {.peaks = {{{30, 9}, 0.66, {4, 3}}, {{16, 17}, 1.64, {7, 8}}, {{35, 32}, 1.3, {5, 8}}}}; }

PeakGround medium() {
  return {.peaks = {{{40, 10}, 1.8, {4, 3}},
                    {{12, 17}, 0.66, {2, 1}},
                    {{21, 25}, 1.86, {4, 4}},
                    {{33, 34}, 1.64, {7, 8}},
                    {{10, 41}, 0.3, {5, 8}},
                    {{14, 32}, 0.96, {12, 8}},
                    {{6, 26}, 1.3, {6, 5}},
                    {{33, 15}, 2.3, {4, 12}}}};
}

TEST(Peaks, SumOfPublishedTerrains) {
  EXPECT_NEAR(simple().height({30, 9}), 0.671173, 5e-7);
  EXPECT_NEAR(simple().height({25, 25}), 0.126587, 5e-7);
  EXPECT_NEAR(medium().height({21, 25}), 2.204757, 5e-7);
  EXPECT_NEAR(medium().height({33, 15}), 2.311914, 5e-7);
  EXPECT_NEAR(medium().height({25, 25}), 1.023326, 5e-7);
  double highest = 0;
  for (int x = 0; x <= 50; ++x)
    for (int y = 0; y <= 50; ++y) highest = std::max(highest, simple().height({x, y}));
  EXPECT_NEAR(highest, 1.64, 5e-7);
}

TEST(Peaks, MaximumOfPublishedTerrains) {
  PeakGround three = simple();
  PeakGround eight = medium();
  three.maximum = eight.maximum = true;
  EXPECT_NEAR(three.height({25, 25}), 0.115514, 5e-7);
  EXPECT_NEAR(eight.height({25, 25}), 0.684256, 5e-7);
}

TEST(Peaks, SteepnessIsABoundAndNearlyReached) {
  for (const bool maximum : {false, true}) {
    PeakGround ground = simple();
    ground.maximum = maximum;
    double steepest = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
      Stream stream(1, 2, i);
      const Vec2 a{50 * stream.uniform(), 50 * stream.uniform()};
      const Vec2 b = a + 0.01 * direction_of(2 * kPi * stream.uniform()).head<2>();
      steepest = std::max(steepest, std::abs(ground.height(b) - ground.height(a)) / (b - a).norm());
    }
    EXPECT_LE(steepest, ground.steepness());
    EXPECT_GT(steepest, 0.2 * ground.steepness());
  }
}

}  // namespace
}  // namespace alate
