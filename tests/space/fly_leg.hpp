// Flies legs with turns in small steps, to compare with what they say of themselves.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "alate/core/stream.hpp"
#include "space/turning_leg.hpp"

namespace alate::test {

inline constexpr double kRadius = 200;

inline Vec3 random_unit(Stream& random) {
  const double z = 2 * random.uniform() - 1;
  const double turn = 2 * kPi * random.uniform();
  const double planar = std::sqrt(1 - z * z);
  return {planar * std::cos(turn), planar * std::sin(turn), z};
}

/// Flies the turn in small chords from the pose; heading and position after it.
inline Pose flown(const Pose& from, const Turn& turn, double radius) {
  constexpr int kSteps = 20000;
  const double step = turn.angle_rad / kSteps;
  Pose at = from;
  for (int k = 0; k < kSteps; ++k) {
    const auto turned = [&](double by) -> Vec3 {
      return std::cos(by) * at.heading + std::sin(by) * turn.normal.cross(at.heading);
    };
    at.position += 2 * radius * std::sin(step / 2) * turned(step / 2);
    at.heading = turned(step);
  }
  return at;
}

/// Flies the whole leg and compares with what it says of itself.
inline void expect_flies(const Pose& from, const TurningLeg& leg, const Vec3& to) {
  Pose at = flown(from, leg.leave, kRadius);
  EXPECT_LT((position_on(leg.leave, from.position, leg.leave.angle_rad) - at.position).norm(), 1e-6);
  at.position += leg.straight_m * at.heading;
  at = flown(at, leg.arrive, kRadius);
  EXPECT_LT((at.position - to).norm(), 1e-6);
  EXPECT_LT((at.heading - leg.heading).norm(), 1e-9);
  EXPECT_NEAR(leg.heading.norm(), 1, 1e-12);
  EXPECT_NEAR(leg.length_m, leg.straight_m + kRadius * (leg.leave.angle_rad + leg.arrive.angle_rad), 1e-9);
  EXPECT_GE(leg.length_m, (to - from.position).norm());
  for (const Turn& turn : {leg.leave, leg.arrive}) {
    EXPECT_GE(turn.angle_rad, 0);
    EXPECT_LT(turn.angle_rad, 2 * kPi);
    EXPECT_NEAR(turn.normal.norm(), 1, 1e-12);
  }
}

}  // namespace alate::test
