#include "space/approach.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

constexpr double kRadius = 100;

TEST(Approach, AheadIsNoDetour) { EXPECT_NEAR(approach_detour({150, 0}, {1, 0}, kRadius, 1), 0, 1e-9); }

TEST(Approach, BesideIsHalfATurn) {
  // Two radii to the side: half a circle instead of the diameter.
  EXPECT_NEAR(approach_detour({0, 200}, {1, 0}, kRadius, 1), kPi * kRadius - 200, 1e-6);
  EXPECT_NEAR(approach_detour({0, -200}, {1, 0}, kRadius, 1), kPi * kRadius - 200, 1e-6);
}

TEST(Approach, InsideTheTurningCircleIsFarAway) {
  EXPECT_GT(approach_detour({0, 50}, {1, 0}, kRadius, 1), kPi * kRadius);
  EXPECT_LT(approach_detour({20, 20}, {1, 0}, kRadius, 25), 10) << "within the tolerance of the circle";
}

TEST(Approach, FadesOutWithDistance) {
  EXPECT_GT(approach_detour({-190, 0}, {1, 0}, kRadius, 1), kPi * kRadius);
  EXPECT_EQ(approach_detour({-400, 0}, {1, 0}, kRadius, 1), 0);
}

TEST(Approach, OnlyTheAngleToTheGoalCounts) {
  const Vec2 direction = Vec2(1, 2).normalized();
  const Vec2 left(-direction.y(), direction.x());
  EXPECT_NEAR(approach_detour(120 * direction + 130 * left, direction, kRadius, 1),
              approach_detour({120, 130}, {1, 0}, kRadius, 1), 1e-9);
}

}  // namespace
}  // namespace alate
