#include "space/turning_leg.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "space/fly_leg.hpp"

namespace alate::test {
namespace {

TEST(ArcTangentLeg, FliesToItsPointFromAnyHeading) {
  int legs = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Stream random(seed, 1, 1);
    const Pose from{1e4 * random_unit(random), random_unit(random)};
    const Vec3 to = from.position + 2000 * random.uniform() * random_unit(random);
    const Vec3 chord = to - from.position;
    const double across = (chord - from.heading.dot(chord) * from.heading).norm();
    const auto leg = arc_tangent_leg(from, to, kRadius);
    ASSERT_EQ(leg.has_value(), chord.squaredNorm() > 2 * kRadius * across) << seed;
    if (!leg) continue;
    ++legs;
    expect_flies(from, *leg, to);
    EXPECT_EQ(leg->arrive.angle_rad, 0);
  }
  EXPECT_GT(legs, 200);
}

TEST(ArcTangentLeg, LeavesTheCircleWhereTheHeadingFirstMeetsThePoint) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Stream random(seed, 2, 1);
    const Pose from{Vec3::Zero(), random_unit(random)};
    const Vec3 to = (450 + 3000 * random.uniform()) * random_unit(random);
    const TurningLeg leg = arc_tangent_leg(from, to, kRadius).value();
    for (double part = 0; part < 0.99; part += 0.01) {
      const double angle = part * leg.leave.angle_rad;
      const Vec3 at = position_on(leg.leave, from.position, angle);
      const Vec3 heading = leg.leave.normal.cross(at - leg.leave.center) / kRadius;
      EXPECT_GT((heading - (to - at).normalized()).norm(), 1e-9);
    }
  }
}

TEST(ArcTangentLeg, StraightAheadIsStraight) {
  for (const Vec3& heading : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.6, 0, -0.8), Vec3(1, 1, 1).normalized()}) {
    const Vec3 from{1e5, -3e4, 700};
    const Vec3 to = from + 1234.5 * heading;
    const auto leg = arc_tangent_leg({from, heading}, to, kRadius);
    ASSERT_TRUE(leg);
    EXPECT_EQ(leg->leave.angle_rad, 0);
    EXPECT_EQ(leg->length_m, (to - from).norm());
  }
}

TEST(ArcTangentLeg, NearlyStraightAheadNeverGoesRound) {
  for (double offset = 1; offset > 1e-300; offset /= 7) {
    const Pose from{Vec3::Zero(), Vec3::UnitX()};
    const Vec3 to{5000, offset, 0};
    const auto leg = arc_tangent_leg(from, to, kRadius);
    ASSERT_TRUE(leg);
    EXPECT_GE(leg->length_m, to.norm());
    EXPECT_LE(leg->length_m, to.norm() + offset * offset + 1e-9) << offset;
    expect_flies(from, *leg, to);
  }
}

TEST(ArcTangentLeg, StraightBehindTurnsLevelToTheLeft) {
  const Pose from{{100, 200, 300}, Vec3::UnitX()};
  const Vec3 to{-900, 200, 300};
  const TurningLeg leg = arc_tangent_leg(from, to, kRadius).value();
  expect_flies(from, leg, to);
  EXPECT_GT(leg.leave.angle_rad, kPi);
  EXPECT_LT((leg.leave.normal - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((leg.leave.center - Vec3(100, 400, 300)).norm(), 1e-9);
  // Hardly off that line the turn is as long, in its own plane.
  const Vec3 beside{-900, 200, 300 + 1e-6};
  EXPECT_NEAR(arc_tangent_leg(from, beside, kRadius).value().length_m, leg.length_m, 1e-3);
}

TEST(ArcTangentLeg, StraightBehindFromAClimbOrADiveTurnsAsIfBoundNorth) {
  for (const double up : {1.0, -1.0}) {
    const Pose from{Vec3::Zero(), up * Vec3::UnitZ()};
    const Vec3 to = -3000 * from.heading;
    const TurningLeg leg = arc_tangent_leg(from, to, kRadius).value();
    expect_flies(from, leg, to);
    EXPECT_LT((leg.leave.center - Vec3(-kRadius, 0, 0)).norm(), 1e-9);
  }
}

TEST(ArcTangentLeg, PointCloseBehindTakesNearlyTheWholeCircle) {
  for (const double distance : {100.0, 1.0, 1e-3, 1e-6}) {
    const Pose from{Vec3::Zero(), Vec3::UnitX()};
    const Vec3 to{-distance, 0, 0};
    const TurningLeg leg = arc_tangent_leg(from, to, kRadius).value();
    expect_flies(from, leg, to);
    EXPECT_GT(leg.leave.angle_rad, 1.5 * kPi);
  }
}

TEST(ArcTangentLeg, ThereIsNoneIntoTheCircleOrNowhere) {
  const Pose from{Vec3::Zero(), Vec3::UnitX()};
  EXPECT_FALSE(arc_tangent_leg(from, {0, 399.999, 0}, kRadius));
  EXPECT_FALSE(arc_tangent_leg(from, {0, 400, 0}, kRadius));
  EXPECT_TRUE(arc_tangent_leg(from, {0, 400.001, 0}, kRadius));
  EXPECT_FALSE(arc_tangent_leg(from, {100, 0, 100}, kRadius));
  EXPECT_FALSE(arc_tangent_leg(from, from.position, kRadius));
  EXPECT_FALSE(arc_tangent_leg(from, {std::nan(""), 0, 0}, kRadius));
}

TEST(FreeHeadingLeg, FliesBetweenAnyPosesSomeRadiiApart) {
  int legs = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Stream random(seed, 3, 1);
    const Pose from{1e4 * random_unit(random), random_unit(random)};
    const Vec3 way = random_unit(random);
    const auto facing = [&](const Vec3& heading) -> Vec3 { return heading.dot(way) < 0 ? -heading : heading; };
    const Pose to{from.position + (1200 + 8000 * random.uniform()) * way, facing(random_unit(random))};
    const Pose begin{from.position, facing(from.heading)};
    const auto leg = free_heading_leg(begin, to, kRadius);
    ASSERT_TRUE(leg) << seed;
    expect_flies(begin, *leg, to.position);
    ++legs;
  }
  EXPECT_EQ(legs, 300);
}

TEST(FreeHeadingLeg, IsTheArcTangentLegWhereItArrivesAsThatDoes) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Stream random(seed, 4, 1);
    const Pose from{Vec3::Zero(), Vec3::UnitX()};
    const Vec3 to = Vec3(3000, 0, 0) + 2500 * random_unit(random);
    const TurningLeg contest = arc_tangent_leg(from, to, kRadius).value();
    const auto leg = free_heading_leg(from, {to, contest.heading}, kRadius);
    if (contest.leave.angle_rad > 0.9 * kPi) continue;
    ASSERT_TRUE(leg) << seed;
    EXPECT_NEAR(leg->length_m, contest.length_m, 1e-7);
  }
}

TEST(FreeHeadingLeg, BetweenHeadingsAlongTheLineIsStraight) {
  const TurningLeg leg = free_heading_leg({{0, 0, 0}, Vec3::UnitZ()}, {{0, 0, 500}, Vec3::UnitZ()}, kRadius).value();
  EXPECT_EQ(leg.length_m, 500);
  EXPECT_EQ(leg.leave.angle_rad + leg.arrive.angle_rad, 0);
}

TEST(FreeHeadingLeg, ThereIsNoneWithoutRoomForItsTurns) {
  EXPECT_FALSE(free_heading_leg({{0, 0, 0}, Vec3::UnitX()}, {{100, 0, 0}, -Vec3::UnitX()}, kRadius));
  EXPECT_FALSE(free_heading_leg({{0, 0, 0}, Vec3::UnitX()}, {{5000, 0, 0}, -Vec3::UnitX()}, kRadius));
  EXPECT_FALSE(free_heading_leg({{0, 0, 0}, Vec3::UnitX()}, {{0, 0, 0}, Vec3::UnitX()}, kRadius));
  EXPECT_FALSE(free_heading_leg({{0, 0, 0}, Vec3::UnitX()}, {{0, 300, 0}, Vec3::UnitX()}, kRadius));
}

}  // namespace
}  // namespace alate::test
